// Several turns, each by itself.
for i in 0..3 {
  x = range(0, 5);
  // conflict 1: x[1] is at most 5
  // conflict 2: x[3] is at most 5
  if i % 2 == 1 then assert(x > 5 + i);
  // conflict 1: x > 5 + i @ assert[1]
  // conflict 2: x > 5 + i @ assert[3]
}
