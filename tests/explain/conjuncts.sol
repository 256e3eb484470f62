// Of a conjunction only those that take part.
x = range(0, 9);
assert(x > 5 and x != 7 and x < 4, "x fits");  // conflict: x > 5; x < 4
