// Two that have nothing to do with each other.
x, y = range(0, 9), range(0, 9);
assert(x > 5);  // conflict 1: x > 5
assert(y > 5);  // conflict 2: y > 5
assert(x < 5);  // conflict 1: x < 5
assert(x + y != 3);
assert(y < 5);  // conflict 2: y < 5
