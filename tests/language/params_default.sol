param n = 2;
param m = n * 3;
return [n, m];
// set: n = 5
// expect: [5, 15]
