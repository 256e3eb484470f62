// A step that is chosen.
// by solvers: a step below one is a mistake
step = range(3, 4);  // conflict: step is at least 3; step is at most 4
x = range(0, 9, step);  // conflict: x is one of the steps of its range
assert(x == 5);  // conflict: x == 5
