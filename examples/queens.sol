// Shows: a puzzle whose solution is a value; nothing is placed.
//
// n queens on an n x n board, none of which attacks another: row[i] is where the queen of column i stands.
// There are 2, 10, 4, 40 and 92 ways for n = 4 to 8: bin/solitaire solve examples/queens.sol --set n=6 --all
param n = 8;

row = [range(0, n - 1) for column in 1..n];
assert(distinct(row), "one queen in each row");
assert(distinct([row[i] + i for i in 0..n - 1]), "one on each falling diagonal");
assert(distinct([row[i] - i for i in 0..n - 1]), "one on each rising diagonal");
return row;
