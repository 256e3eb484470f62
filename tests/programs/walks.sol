// Self-avoiding walks on the square lattice.
param steps = 5;
steps_to = [[1, 0], [0, 1], [-1, 0], [0, -1]];
path = [[0, 0]];
for i in 1..steps {
  dx, dy = choose(steps_to);
  path += [[path[i - 1][0] + dx, path[i - 1][1] + dy]];
}
assert(distinct(path));
return path;
