// Both ends.
x = range(2, 4);  // conflict: x is at least 2; x is at most 4
assert(x * x < 4 or x * x > 16);  // conflict: x * x < 4 or x * x > 16
