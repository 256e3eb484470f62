// A recursion that a remainder of what is left ends: that it goes no deeper follows from what is known on each path.
fun fall(p) {
  if p <= 0 { return 0; }
  p %= range(0, 4);
  return 1 + fall(p - 1);
}
return [fall(5), fall(5)];
// expect solutions: 49
// expect: [2, 2]
