// More groups than the floor has space for.
param groups = 3;

fun make_group() {
  x = range(0, 7);  // conflict: make_group[0]/x is at least 0; make_group[2]/x is at most 7
  assert(x % 2 == 0, "on the carpet's pattern");
  return x;
}
xs = [make_group() for i in 1..groups];
for i in 0..groups - 2 { assert(xs[i] + 4 <= xs[i + 1], "a way between the groups"); }
// conflict: xs[i] + 4 <= xs[i + 1] @ assert[0]; xs[i] + 4 <= xs[i + 1] @ assert[1]
