// Lists of a chosen length: unions of shapes that everything distributes over.
n = range(0, 3);
xs = [i * i for i in 1..n];
ys = xs + (if flip() then [100] else []);
total = 0;
for y in ys: total += y;
assert(length(ys) >= 2);
ys[1] = -1;
return [ys, total, length(xs), contains(ys, 100), sum(xs), reverse(xs)];
// expect: [[1, -1], 101, 1, false, 1, [1]]
// expect: [[1, -1], 5, 2, false, 5, [4, 1]]
// expect: [[1, -1, 100], 105, 2, true, 5, [4, 1]]
// expect: [[1, -1, 9], 14, 3, false, 14, [9, 4, 1]]
// expect: [[1, -1, 9, 100], 114, 3, true, 14, [9, 4, 1]]
