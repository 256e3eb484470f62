// An assert keeps executions from a mistake; they end there and fulfil what follows.
// by solvers: executions that break the first assert come to a mistake
x = range(0, 9);
assert(x < 5, "a name for each");  // conflict: x < 5
if x >= 5 then name = 1 + "a" else name = "b";
assert(x > 6);  // conflict: x > 6
