// A chosen condition in each of many turns.
// $ solve
// says: 1 solution
param n = 2200;
xs = [range(0, 9) for i in 0..n];
for i in 0..n - 1 { if xs[i] < 5 then assert(xs[i + 1] != 3); }
