// cond evaluates both values, an if expression only one.
n = range(0, 2);
a = cond(n == 1, range(10, 11), range(20, 20));
b = if n == 1 then 1 else [n][n];
return [n, a, b];
// expect: [0, 20, 0]
// expect: [0, 20, 0]
// expect: [1, 10, 1]
// expect: [1, 11, 1]
