// Rules between neighbours by `or`.
// $ solve --all
// says: 144 solutions
// says: proved that there is no other
param n = 2;
grid = [[range(0, 3) for x in 1..n] for y in 1..n];
for y in 0..n - 1 {
  for x in 0..n - 2 {
    a, b = grid[y][x], grid[y][x + 1];
    assert(a != 0 or b != 0, "no two water");
    assert(a != 1 or b != 2);
    assert(a != 2 or b != 3);
    assert(a != 3 or b != 1);
  }
}
return sum([sum(row) for row in grid]);
