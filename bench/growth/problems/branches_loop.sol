// A condition on a choice in each turn of a loop.
param n = 1000;
xs = [range(0, 9) for i in 0..n];
for i in 0..n - 1 { if xs[i] < 5 then assert(xs[i + 1] != 3); }
return n;
