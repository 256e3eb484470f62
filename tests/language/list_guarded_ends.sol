// Lists of different lengths have their ends in common, or nothing; indices past the end rule executions out.
long = flip();
a = if long then [1, 2, 3] else [3];
b = if long then [7, 8] else ["x"];
nested = if flip() then [a] else [a, b];
i = range(0, 2);
return [a[i], nested[i % 2], length(nested), choose(b)];
// expect: [1, [1, 2, 3], 1, 7]
// expect: [1, [1, 2, 3], 1, 8]
// expect: [3, [1, 2, 3], 1, 7]
// expect: [3, [1, 2, 3], 1, 8]
// expect: [1, [1, 2, 3], 2, 7]
// expect: [1, [1, 2, 3], 2, 8]
// expect: [2, [7, 8], 2, 7]
// expect: [2, [7, 8], 2, 8]
// expect: [3, [1, 2, 3], 2, 7]
// expect: [3, [1, 2, 3], 2, 8]
// expect: [3, [3], 1, "x"]
// expect: [3, [3], 2, "x"]
