fun f(a, b = range(0, a)) { return a + b; }
record R(x, y = range(0, 1), z = flip());
n = range(0, 2);
return [f(n), f(1), R(1), R(2)];
