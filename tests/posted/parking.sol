// More stalls than a lot has: what stands against them is told once for all its squares.
// $ explain
// status: 1
// says: cannot hold together:
// says: note: 9 times, first at y = 0, x = 0; y = 0, x = 1
// says: where x = 0, y = 0
param stalls = 9;
grid = [[range(0, 1) for x in 0..2] for y in 0..2];
fun at(x, y) { return if x in 0..2 and y in 0..2 then grid[y][x] else -1; }
cells = [[x, y] for y in 0..2 for x in 0..2];
assert(sum([grid[y][x] for x, y in cells]) >= stalls, "enough stalls");
for x, y in cells {
  assert(grid[y][x] == 0 or 0 in [at(x - 1, y), at(x + 1, y), at(x, y - 1), at(x, y + 1)], "each stall on a lane");
}
