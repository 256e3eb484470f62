// n digits, each different from the one before.
param n = 10000;
xs = [range(0, 9) for i in 1..n];
for i in 0..n - 2 { assert(xs[i] != xs[i + 1]); }
return n;
