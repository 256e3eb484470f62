// Arithmetic on both sides.
x = range(0, 6);
assert(2 * x == 7);  // conflict: 2 * x == 7
