s = range(-1, 2);
y = sqrt(s);
assert(s > 0);
return y;
