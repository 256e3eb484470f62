// Functions of lists whose elements each have a condition of their own look at each element once, under its condition.
a, b, c = range(0, 3), range(1, 2), range(2, 4);
xs = [x for x in [a, b, c] if x != 2];
some = [x for x in [a, c] if x > 2];
assert(a != b and c != 3);
values = [];
if length(some) > 0 { values = [first(some), last(some), min(some), max(some)]; }
known = [7] + some;
words = [w for w in ["one", "two", "three"] if length(w) > b + 1];
mixed = [m for m in [a, 0.5] if m != 0];
found = -1;
if contains(xs, 4) { found = index_of(xs, 4); }
pairs_of = [t[0] + t[1] for t in zip(xs, [10, 20, 30])];
numbered = [e[0] * 10 + e[1] for e in enumerate(some)];
return [values, first(known), last(known), min(known), max(known), sort(xs), distinct(xs), words, last(words), min(mixed), max(mixed),
        found, pairs_of, numbered, sort(known), zip(some, xs), distinct(known + some)];
// expect solutions: 12
// expect: [[], 7, 7, 7, 7, [0], true, ["three"], "three", 0.5, 0.5, -1, [10], [], [7], [], true]
