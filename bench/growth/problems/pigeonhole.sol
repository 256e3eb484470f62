// n guests and one seat too few: no solution.
param n = 8;
seats = [range(1, n - 1) for i in 1..n];
assert(distinct(seats));
return seats[0];
