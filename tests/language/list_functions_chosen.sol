// What lists hold, how long they are, and which function is used is chosen.
xs = [range(0, 2), 1, range(0, 1)];
n = range(0, 2);
part = xs[0..n];
by = choose([fun(x) { return x; }, fun(x) { return -x; }]);
sorted = sort(xs, key: by);
assert(first(sorted) != last(sorted));
assert(xs[0] in part and n in [0, 2]);
return xs, n, count(part, 1), index_of(xs, 1), sorted, map(by, part), filter(fun(x) { return x > 0; }, part),
       max(xs, key: by), xs[0] in n..2;
// expect solutions: 20
// expect: [[0, 1, 1], 0, 0, 1, [0, 1, 1], [0], [], 1, true]
// expect: [[2, 1, 0], 2, 1, 1, [2, 1, 0], [-2, -1, 0], [2, 1], 0, true]
// expect: [[2, 1, 0], 2, 1, 1, [0, 1, 2], [2, 1, 0], [2, 1], 2, true]
