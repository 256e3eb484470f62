// The solution has x = 1; only executions know the second text.
x = range(0, 1);
s = str(x) + str(range(0, 2));
assert(s == format("{:2}", 10 * x));
return s;
