// A recursion whose depth is chosen, at least half of n.
param n = 400;
fun depth(left) {
  if left == 0 { return 0; }
  if flip() { return 0; }
  return 1 + depth(left - 1);
}
d = depth(n);
assert(2 * d >= n);
return d;
