// Nothing is said against a condition that the solver cannot express.
x = range(0, 9999);  // conflict: x is at least 0
assert(x < 0, "never");  // conflict: x < 0
assert(length(str([x])) > 3 and x != 3);
