// Rules between neighbours by `if`; rules_by_or.sol has the same rules.
// $ solve --all
// says: 144 solutions
// says: proved that there is no other
param n = 2;
grid = [[range(0, 3) for x in 1..n] for y in 1..n];
for y in 0..n - 1 {
  for x in 0..n - 2 {
    a, b = grid[y][x], grid[y][x + 1];
    if a == 0 then assert(b != 0, "no two water");
    if a == 1 then assert(b != 2);
    if a == 2 then assert(b != 3);
    if a == 3 then assert(b != 1);
  }
}
return sum([sum(row) for row in grid]);
