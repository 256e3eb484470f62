// choose() from a list of chosen length is one choice, whatever the length.
n = range(1, 3);
x = choose(1..n);
return [n, x];
// expect: [1, 1]
// expect: [2, 1]
// expect: [2, 2]
// expect: [3, 1]
// expect: [3, 2]
// expect: [3, 3]
// expect choice: x = 2
