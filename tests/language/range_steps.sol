return [range(-5, 5, 4), range(lo: 0, hi: 7, step: 7), range(3, 5, 10)];
// expect: [-5, 0, 3]
// expect: [-1, 0, 3]
// expect: [3, 0, 3]
// expect: [-5, 7, 3]
// expect: [-1, 7, 3]
// expect: [3, 7, 3]
