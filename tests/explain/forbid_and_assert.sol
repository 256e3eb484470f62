// forbid: x=4
x = range(0, 9);  // conflict: x is not 4, by --forbid 'x=4'
assert(x > 3 and x < 5);  // conflict: x > 3; x < 5
