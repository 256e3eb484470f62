d = range(-2, 2);
return [12 / d, 12 % d];
// expect: [-6, 0]
// expect: [-12, 0]
// expect: [12, 0]
// expect: [6, 0]
