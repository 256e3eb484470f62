// all(...) gives one bool, so it is one condition.
x = range(0, 9);
assert(all(x > 5, x < 3, x != 4));  // conflict: all(x > 5, x < 3, x != 4)
