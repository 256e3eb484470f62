// Out of reach, in a product.
x, y = range(1, 9), range(1, 9);  // conflict: x is at least 1; x is at most 9; y is at most 9
assert(x * y > 200 and x != y);  // conflict: x * y > 200
