// Operations distribute over a union: of each alternative what that alternative gives.
x = choose([3, [1, 2], "ab"]);
n = if x == 3 then x + 1 else length(x);
y = if flip() then [x] else x;
return [n, y == x, y == [x], contains([3, "ab"], x)];
// expect: [4, false, true, true]
// expect: [4, true, false, true]
// expect: [2, false, true, false]
// expect: [2, true, false, false]
// expect: [2, false, true, true]
// expect: [2, true, false, true]
