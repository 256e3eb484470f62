fun make() {
  x = 1;
  f = fun(y) { return x + y; };
  if flip() { return f; }
  x = 5;
  if flip() { return f; }
  x = "a";
  return f;
}
g = make();
return g(1);
