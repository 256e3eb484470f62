// A permutation of n numbers.
param n = 100;
xs = [range(1, n) for i in 1..n];
assert(distinct(xs));
return xs[0];
