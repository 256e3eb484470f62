// A map of which half is land, and all land hangs together: each land cell is one step further than a neighbour.
param n = 6;
far = n * n;
land = [[flip() for x in 1..n] for y in 1..n];
step = [[range(0, far) for x in 1..n] for y in 1..n];
fun step_at(x, y) {
  if x < 0 or y < 0 or x >= n or y >= n then return far;
  return step[y][x];
}
root_x, root_y = range(0, n - 1), range(0, n - 1);
for y in 0..n - 1 {
  for x in 0..n - 1 {
    near = min(step_at(x - 1, y), step_at(x + 1, y), step_at(x, y - 1), step_at(x, y + 1));
    assert(cond(land[y][x], step[y][x] == cond(x == root_x and y == root_y, 0, near + 1) and step[y][x] < far,
                step[y][x] == far));
  }
}
assert(land[root_y][root_x]);
assert(sum([cond(l, 1, 0) for row in land for l in row]) == n * n / 2);
return n;
