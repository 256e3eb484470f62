// The same operations where a solver has to do them.
a = range(-7, 7, 7);
b = choose([-2, 2, 3]);
return [a, b, a / b, a % b, mod(a, b), a * b - a, abs(a), min(a, b), max(a, b), -a];
// expect: [-7, -2, 3, -1, -1, 21, 7, -7, -2, 7]
// expect: [-7, 2, -4, 1, 1, -7, 7, -7, 2, 7]
// expect: [-7, 3, -3, 2, 2, -14, 7, -7, 3, 7]
// expect: [0, -2, 0, 0, 0, 0, 0, -2, 0, 0]
// expect: [0, 2, 0, 0, 0, 0, 0, 0, 2, 0]
// expect: [0, 3, 0, 0, 0, 0, 0, 0, 3, 0]
// expect: [7, -2, -4, -1, -1, -21, 7, -2, 7, -7]
// expect: [7, 2, 3, 1, 1, 7, 7, 2, 7, -7]
// expect: [7, 3, 2, 1, 1, 14, 7, 3, 7, -7]
