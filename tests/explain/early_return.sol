// What stands behind a return is not met by those that return.
fun height(x) {
  if x < 5 then return 10;
  assert(x > 7);  // conflict: x > 7 @ height/assert
  return 20;
}
x = range(0, 9);
h = height(x);
assert(h == 20 and x < 7);  // conflict: h == 20; x < 7
