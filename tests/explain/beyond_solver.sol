// What the solver cannot express, where no execution comes that breaks nothing.
x = range(0, 9);  // conflict: x is at least 0
assert(x < 0, "never");  // conflict: x < 0
y = 0.5 * x;
if y > 3 then z = 1 else z = 2;
