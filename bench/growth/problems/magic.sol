// Magic squares of order n, turned and mirrored ones left out.
param n = 3;
square = [[range(1, n * n) for c in 1..n] for r in 1..n];
assert(distinct([x for row in square for x in row]));
total = n * (n * n + 1) / 2;
for row in square: assert(sum(row) == total);
for c in 0..n - 1: assert(sum([row[c] for row in square]) == total);
assert(sum([square[i][i] for i in 0..n - 1]) == total);
assert(sum([square[i][n - 1 - i] for i in 0..n - 1]) == total);
assert(square[0][0] < square[0][n - 1] and square[0][0] < square[n - 1][0] and square[0][0] < square[n - 1][n - 1]);
assert(square[0][n - 1] < square[n - 1][0]);
return square;
