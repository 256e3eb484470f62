// A value between two steps.
x = range(0, 20, 4);  // conflict: x is one of the steps of its range
assert(x > 4 and x < 8);  // conflict: x > 4; x < 8
