// $ solve
// status: 1
// says: cannot hold together:
seats = [range(1, 10) for i in 1..11];
assert(distinct(seats));
