// Langford's problem: two cards of each number k, with k cards between them.
param n = 7;
first = [range(0, 2 * n - 1) for k in 1..n];
second = [first[k - 1] + k + 1 for k in 1..n];
for p in second: assert(p < 2 * n);
assert(distinct(first + second));
return first;
