// The solution has x = 1: the field of two letters begins with a space where x is 0.
x = range(0, 1);
s = str(x) + str(range(0, 2));
assert(s == format("{:2}", 10 * x));
return s;
