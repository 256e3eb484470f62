// The branch that x goes into.
x, y = range(0, 9), range(0, 9);
if x > 6 then assert(y < 3) else assert(y > 7);  // conflict: y < 3
assert(x == 8 and y == 5);  // conflict: x == 8; y == 5
