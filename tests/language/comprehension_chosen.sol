n = range(1, 3);
xs = [range(0, 1) for i in 1..n];
ones = [i for i in 0..length(xs) - 1 if xs[i] == 1];
assert(length(ones) == 2);
return [xs, ones];
// expect: [[1, 1], [0, 1]]
// expect: [[1, 1, 0], [0, 1]]
// expect: [[1, 0, 1], [0, 2]]
// expect: [[0, 1, 1], [1, 2]]
// expect choice: xs[2] = 1
