// The steps of a staircase are as high as people can climb, and do not reach the floor above.
fun climb(steps, height) {
  if steps == 0 then return height;
  rise = range(1, 2);
  // conflict: climb/rise is at most 2; climb/climb/rise is at most 2; climb/climb/climb/rise is at most 2
  // conflict: climb/climb/climb/climb/rise is at most 2
  return climb(steps - 1, height + rise);
}
top = climb(4, 0);
assert(top == 9, "the floor above");  // conflict: top == 9
