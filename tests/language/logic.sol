fun bad() { return 1 / 0 == 0; }            // would rule the execution out
print(false and bad(), true or bad());      // prints: false true
print(true and false or true, true or true and false);  // prints: true true
print(not (true and false), not false and true);        // prints: true true
print(all([]), any([]), all([true, true]), any([false, true]), all(true, false), any(true, false));  // prints: true false true true false true
a = flip();
b = flip();
c = a and b or not a and not b;             // are they the same
return [a, b, c, a == b, all([a, b]), any(a, b)];
// expect: [false, false, true, true, false, false]
// expect: [false, true, false, false, false, true]
// expect: [true, false, false, false, false, true]
// expect: [true, true, true, true, true, true]
