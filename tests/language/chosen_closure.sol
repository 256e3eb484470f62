// Closures of the same code over different variables are different functions.
fun adder(n) { return fun(x) { return x + n; }; }
f = adder(1);
if flip() { f = adder(10); }
g = if flip() then f else adder(100);
return [f(0), g(0)];
// expect: [1, 1]
// expect: [10, 10]
// expect: [1, 100]
// expect: [10, 100]
