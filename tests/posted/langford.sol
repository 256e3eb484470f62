// Langford's problem of order 4 has one answer and its mirror image.
// $ solve --all
// says: 2 solutions
// says: proved that there is no other
param n = 4;
at = [range(0, 2 * n - 1) for k in 1..n];
for k in 1..n: assert(at[k - 1] + k + 1 < 2 * n);
assert(distinct(at + [at[k - 1] + k + 1 for k in 1..n]));
