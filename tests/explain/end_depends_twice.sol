// Ends that depend on each other in a chain.
a = range(0, 3);  // conflict: a is at most 3
b = range(a, a + 2);  // conflict: b is not above its range
c = range(b, b + 2);  // conflict: c is not above its range
assert(c == 8);  // conflict: c == 8
