// Latin squares of order n.
param n = 3;
square = [[range(0, n - 1) for c in 1..n] for r in 1..n];
for row in square: assert(distinct(row));
for c in 0..n - 1: assert(distinct([row[c] for row in square]));
return square;
