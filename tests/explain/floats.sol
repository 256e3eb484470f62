// Floats that no choice decides.
width = 2.5;
x = range(0, 3);
assert(width * 2 > 5.5, "wide enough");  // conflict: width * 2 > 5.5
place("table", at: [x * 0.5, 0]);
