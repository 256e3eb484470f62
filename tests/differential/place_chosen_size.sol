x = range(0, 3);
place("box", size: [x, 1]);
assert(x > 0);
