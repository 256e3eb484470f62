fun double(x) { return 2 * x; }
fun pair(x) { return [x, x]; }
record Box(size);
f = choose([double, pair, Box, fun(x) { return x - 1; }, abs]);
return f(range(-1, 0) * 3);
// expect: -6
// expect: 0
// expect: [-3, -3]
// expect: [0, 0]
// expect: Box(size: -3)
// expect: Box(size: 0)
// expect: -4
// expect: -1
// expect: 3
// expect: 0
