// A list each of whose elements may be missing: what looks at elements, at places and at the whole.
xs = [];
for i in 1..4 { if flip() { xs = xs + [i * 10]; } }
assert(length(xs) >= 2);
ys = [x + 1 for x in xs if x > 10];
firsts = cons(5, reverse(xs));
changed = xs;
k = range(0, 1);
changed[k] = 0;
return [xs, ys, xs[k], length(ys), pairs(xs), cdr(firsts), 20 in xs, sum(xs), null(ys), max(xs), xs == [10, 20],
        xs == changed, last(xs), zip(xs, ys), enumerate(ys), count(xs, 30), all([x > 10 for x in xs]), changed];
// expect solutions: 22
// expect: [[10, 20], [21], 10, 1, [[10, 20]], [20, 10], true, 30, false, 20, true, false, 20, [[10, 21]], [[0, 21]], 0, false, [0, 20]]
// expect: [[20, 30, 40], [21, 31, 41], 30, 3, [[20, 30], [20, 40], [30, 40]], [40, 30, 20], true, 90, false, 40, false, false, 40, [[20, 21], [30, 31], [40, 41]], [[0, 21], [1, 31], [2, 41]], 1, true, [20, 0, 40]]
