s = range(0, 2);
unit(s);
assert(s > 0);
