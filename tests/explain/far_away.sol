// Out of reach by much.
x = range(0, 1);  // conflict: x is at most 1
assert(x > 1000);  // conflict: x > 1000
