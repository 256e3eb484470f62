// An assert whose arguments are given by name is one condition.
x = range(0, 9);
assert(message: "not too large", condition: x > 5 and x < 20);
// conflict: assert(message: "not too large", condition: x > 5 and x < 20)
assert(x % 7 < 3 and x < 7);  // conflict: x % 7 < 3; x < 7
