// The turn that cannot be done.
for size in [2, 7, 3] {
  x = range(0, 5);  // conflict: x[1] is at most 5
  assert(x >= size, "the shelf carries it");  // conflict: x >= size @ assert[1]
}
