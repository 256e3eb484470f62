// The turn of a while loop.
rest = 9;
while rest > 0 {
  part = range(1, 3);  // conflict: part[2] is at least 1
  assert(part + 2 < rest, "something is left");  // conflict: part + 2 < rest @ assert[2]
  rest -= 3;
}
