// A constant list of n numbers, looked at in a chosen place.
param n = 10000;
xs = [(i * 7919) % 1000 for i in 0..n - 1];
i = range(0, n - 1);
assert(xs[i] == 500);
return i;
