// pin: x=12
x = range(0, 9);  // conflict: x is at most 9; x is 12, by --pin 'x=12'
y = range(0, 9);
assert(y > 2);
