// A Steiner triple system: triples of n points, so that each pair of points stands in exactly one.
param n = 7;
triples = [[range(0, n - 1) for k in 1..3] for t in 1..n * (n - 1) / 6];
for t in triples: assert(t[0] < t[1] and t[1] < t[2]);
assert(distinct([a * n + b for t in triples for a, b in [[t[0], t[1]], [t[0], t[2]], [t[1], t[2]]]]));
return triples;
