// No execution makes more than some twenty steps, but there are paths, which none takes, on which the text doubles at each call.
fun f(p, s) {
  if p <= 0 { return false; }
  p %= cond(p < -2, -2, 4);
  v = f(p - 1, s + s);
  return cond(v, v, false);
}
x = range(-1, 1);
return f(x, "b");
