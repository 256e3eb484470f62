// A float that is made of an int and no other float.
x = range(0, 2);
assert(x == sqrt(x));
return x;
