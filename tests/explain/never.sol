// Nothing but a constant.
param most = 3;
assert(most > 4, "room for five");  // conflict: most > 4
// set: most = 2
