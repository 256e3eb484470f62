// A divisor that is zero.
x = range(1, 3);
return x % (x - x);  // conflict: the divisor must not be zero
