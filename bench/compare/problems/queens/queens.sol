// n queens on an n x n board, none of which attacks another: row[i] is where the queen of column i stands.
param n = 8;

row = [range(0, n - 1) for column in 1..n];
assert(distinct(row));
assert(distinct([row[i] + i for i in 0..n - 1]));
assert(distinct([row[i] - i for i in 0..n - 1]));
return row;
