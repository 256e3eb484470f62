// A table says which values may follow which. A value without a row is followed by nothing; two rows of one value both hold.
table = [["a", ["a", "b"]], ["b", ["c"]], ["b", ["a", "c"]]];
x = choose(["a", "b", "c"]);
y = choose(["a", "b", "c", "d"]);
assert(allowed(table, x, y));                 // aa ab bc
n = range(0, 3);
m = range(0, 3);
assert(allowed([[i, [j for j in 0..3 if (i + j) % 3 == 0]] for i in 0..2], n, m));  // 00 03 12 21
assert(not allowed(table, "c", "a"));
kind = choose([1, "a", nil]);
assert(allowed([[1, [true]], [nil, ["a"]]], kind, cond(kind == 1, true, "a")));  // 1, nil
right, below = tile_pairs([[1, 2], [2, 2]])[1..2];
assert(right == [[1, [2]], [2, [2]]] and below == [[1, [2]], [2, [2]]]);
return x, y, n, m, kind;
// expect solutions: 24
