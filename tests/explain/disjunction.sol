// What stands below an `or` is not taken apart.
x = range(0, 9);
assert(x < 2 or (x > 7 and x != 8));  // conflict: x < 2 or (x > 7 and x != 8)
assert(x > 2 and x < 9);  // conflict: x > 2; x < 9
