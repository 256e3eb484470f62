// A divisor that has to be zero.
x = range(-3, 3);
assert(x + x == 0, "in the middle");  // conflict: x + x == 0
return 6 / x;  // conflict: the divisor must not be zero
