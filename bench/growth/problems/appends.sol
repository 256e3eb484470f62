// A list of chosen length: each of n numbers is in it or not.
param n = 50;
xs = [];
for i in 1..n {
  if flip() { xs = xs + [range(0, 9)]; }
}
assert(sum(xs) == 2 * n);
return length(xs);
