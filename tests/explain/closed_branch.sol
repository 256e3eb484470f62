// A branch that a constant decides.
param strict = true;
x = range(0, 9);
if strict then assert(x < 4) else assert(x < 8);  // conflict: x < 4
assert(x > 4 and x < 7);  // conflict: x > 4
