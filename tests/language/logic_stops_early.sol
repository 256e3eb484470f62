// The right side runs, and makes its choices, only where the left side leaves the matter open.
a = flip();
b = a and range(1, 3) == 2;
c = a or range(1, 2) == 1;
return [a, b, c];
// expect: [false, false, true]
// expect: [false, false, false]
// expect: [true, false, true]
// expect: [true, true, true]
// expect: [true, false, true]
