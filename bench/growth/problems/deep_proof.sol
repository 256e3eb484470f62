// A recursion that a remainder steers, twice. That there are no further solutions has to be proved.
param n = 5;
fun fall(p) {
  if p <= 0 { return 0; }
  p %= range(0, 4);
  fall(p - 1);
}
fall(n);
fall(n);
