param n = 6;
row = [range(1, n) for column in 1..n];
assert(distinct(row));
assert(distinct([row[i] + i for i in 0..n - 1]));
assert(distinct([row[i] - i for i in 0..n - 1]));
return row;
