// A recursion that a remainder steers; that it goes no deeper has to be proved.
// $ solve --all
// says: 16 solutions
// says: proved that there is no other
fun fall(p) {
  if p <= 0 { return 0; }
  p %= range(0, 4);
  fall(p - 1);
}
fall(4);
fall(4);
