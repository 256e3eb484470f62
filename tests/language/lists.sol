xs = [1, 2, 3];
print(xs[0], xs[2], length(xs), sum(xs), xs + [4], [] + []);   // prints: 1 3 3 6 [1, 2, 3, 4] []
print(reverse(xs), contains(xs, 2), contains(xs, 5), distinct(xs), distinct([1, 1]));  // prints: [3, 2, 1] true false true false
print(pairs(xs), pairs([1]), zip(xs, ["a", "b"]));  // prints: [[1, 2], [1, 3], [2, 3]] [] [[1, "a"], [2, "b"]]
print(cons(0, xs), car(xs), cdr(xs), null([]), null(xs), cdr([1]));  // prints: [0, 1, 2, 3] 1 [2, 3] true false []
print(0..3, 2..2, 3..0, 0..length(xs) - 1, -1..1);      // prints: [0, 1, 2, 3] [2] [] [0, 1, 2] [-1, 0, 1]
print([[1, 2], [3]][1][0], [1, nil, true, 2.5, "s"], sum([]), max(xs[0], xs[1]));  // prints: 3 [1, nil, true, 2.5, "s"] 0 2
