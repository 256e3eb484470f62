// Shows: arithmetic constraints, and a puzzle that is solved by its value alone.
//
// The numbers 1 .. n * n in a square whose rows, columns and diagonals have one sum. There are 8 of size 3:
// bin/solitaire solve examples/magic_square.sol --all
param n = 3;

square = [[range(1, n * n, 1) for column in 1..n] for row in 1..n];
total = n * (n * n + 1) / 2;

assert(distinct([cell for row in square for cell in row]), "each number once");
for i in 0..n - 1 {
  assert(sum(square[i]) == total, "rows");
  assert(sum([row[i] for row in square]) == total, "columns");
}
assert(sum([square[i][i] for i in 0..n - 1]) == total, "falling diagonal");
assert(sum([square[i][n - 1 - i] for i in 0..n - 1]) == total, "rising diagonal");
return square;
