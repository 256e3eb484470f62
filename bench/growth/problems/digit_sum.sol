// n digits with a given sum.
param n = 100;
xs = [range(0, 9) for i in 1..n];
assert(sum(xs) == 4 * n);
return sum(xs);
