// A parking lot of n by n cells: lanes that hang together from the gate on, and half of the cells are stalls beside them.
param n = 8;
param stalls = 31;
LANE, STALL, TREE = 0, 1, 2;
grid = [[range(0, 2) for x in 1..n] for y in 1..n];
steps = [[range(0, 2 * n) for x in 1..n] for y in 1..n];   // to the gate
gate = range(0, n - 1);
cells = [[x, y] for y in 0..n - 1 for x in 0..n - 1];
fun beside(x, y) { return [[a, b] for a, b in [[x - 1, y], [x + 1, y], [x, y - 1], [x, y + 1]] if min(a, b) >= 0 and max(a, b) < n]; }

assert(count([grid[y][x] == STALL for x, y in cells]) >= stalls, "enough stalls");
assert(grid[0][gate] == LANE, "the gate opens on a lane");
for x, y in cells {
  near = min([2 * n] + [steps[b][a] for a, b in beside(x, y)]);
  if grid[y][x] == STALL then assert(any([grid[b][a] == LANE for a, b in beside(x, y)]), "a stall on a lane");
  if grid[y][x] != LANE then assert(steps[y][x] == 2 * n);
  else if y == 0 and x == gate then assert(steps[y][x] == 0);
  else assert(steps[y][x] == near + 1, "lanes hang together");
}
fun show(x, y) {
  if grid[y][x] == STALL then place("stall", at: [x, y], size: [0.9, 0.9, 0.02]);
  if grid[y][x] == TREE then place("tree", at: [x, y], size: [0.9, 0.9]);
}
for x, y in cells: show(x, y);
return n;
