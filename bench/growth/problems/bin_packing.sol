// As few bins as can be for n items; what they weigh together is the bound.
param n = 12;
weights = [57, 49, 46, 44, 42, 38, 33, 31, 29, 27, 25, 23, 19, 17, 14, 12, 9, 8, 6, 4, 3];
items = [weights[i % length(weights)] for i in 0..n - 1];
bin = [range(0, n - 1) for i in items];
used = range(1, n);
for b in bin: assert(b < used);
for k in 0..n - 1: assert(sum([cond(bin[i] == k, items[i], 0) for i in 0..n - 1]) <= 100);
minimize(used);
return used;
