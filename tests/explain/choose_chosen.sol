// Whether there is something to choose from is chosen.
n = range(0, 3);
xs = [i * i for i in 1..n];
pick = choose(xs);  // conflict: there must be something to choose from
assert(n < 1, "few");  // conflict: n < 1
