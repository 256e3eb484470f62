// pin: x=3
x = range(0, 9);  // conflict: x is 3, by --pin 'x=3'
assert(x > 5);  // conflict: x > 5
