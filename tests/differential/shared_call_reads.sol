n = range(0, 2);
v = range(0, 2);
fun f(q) {
  assert(q != v);
  if q < v { return v - q; }
  return v + 10;
}
if n < 1 {
  v = v + 1;
  r = f(1);
} else {
  r = f(1);
}
assert(r != 12);
return [r, v];
