// Nothing to choose from.
x = range(0, 3);
assert(x > 1);
colour = choose([]);  // conflict: there must be something to choose from
