// Four bins of 100 hold all 340, and three do not.
// $ solve
// says: solution 1: 4
// says: cost 4
param items = [57, 49, 46, 44, 42, 38, 33, 31];
param cap = 100;
b = [range(0, length(items) - 1) for i in items];
used = range(1, length(items));
for i in 0..length(items) - 1: assert(b[i] < used);
for k in 0..length(items) - 1: assert(sum([if b[i] == k then items[i] else 0 for i in 0..length(items) - 1]) <= cap);
minimize(used);
return used;
