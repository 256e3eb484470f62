// Without an argument, unit() says how long a unit is.
print(unit());                // prints: 1.0
unit(0.25);
print(unit(), 0.5 / unit());  // prints: 0.25 2.0
fun half() { return 0.5 / unit(); }
x = range(1, 3);
assert(x > half());
place("box", at: [x + half(), 0]);
// expect solutions: 1
// expect choice: x = 3
