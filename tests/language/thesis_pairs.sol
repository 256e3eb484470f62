// Section 4.1.1.
x = range(0,10);
y = range(0,10);
assert(x + y == 10);
return x,y;
// expect solutions: 11
// expect: [4, 6]
// expect: [1, 9]
