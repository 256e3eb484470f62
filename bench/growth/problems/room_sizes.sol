// Rooms whose sides are chosen, one beside the other, as places with those sizes.
param n = 6;
w = [range(1, 6) for i in 1..n];
d = [range(1, 6) for i in 1..n];
assert(sum([w[i] * d[i] for i in 0..n - 1]) == 12 * n);
at = 0;
for i in 0..n - 1 {
  place("room", at: [at, 0], size: [w[i], d[i], 1]);
  at = at + w[i];
}
return at;
