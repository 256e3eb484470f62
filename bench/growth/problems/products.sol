// Boxes of whole edges whose volume and surface are equal to those of another one.
param n = 12;
a, b, c = range(1, n), range(1, n), range(1, n);
d, e, f = range(1, n), range(1, n), range(1, n);
assert(a * b * c == d * e * f);
assert(a <= b and b <= c and d <= e and e <= f);
return [a, b, c, d, e, f];
