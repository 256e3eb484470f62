x = range(0, 9);
y = range(0, 9);
assert(x * x + y * y == 3);
return x;
// expect solutions: 0
