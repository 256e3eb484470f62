// Either side has its own condition.
x = range(0, 9);
if flip() then assert(x < 3, "small"); else assert(x < 2, "smaller");  // conflict: x < 3; x < 2
assert(x > 5, "large");  // conflict: x > 5
