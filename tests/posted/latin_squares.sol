// $ count
// says: 576 solutions
param n = 4;
g = [[range(0, n - 1) for c in 1..n] for r in 1..n];
for r in g: assert(distinct(r));
for c in 0..n - 1: assert(distinct([r[c] for r in g]));
return g;
