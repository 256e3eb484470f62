print(1.5 + 1, 3.0, 0.1, 1e3, 2.5e-3, 7 / 2.0, -0.5);  // prints: 2.5 3.0 0.1 1000.0 0.0025 3.5 -0.5
print(1 == 1.0, 1.5 < 2, 2 <= 1.5, abs(-2.5), min(1, 0.5), max(1, 0.5));  // prints: true true false 2.5 0.5 1.0
print(abs(0.0), abs(-2.5));   // prints: 0.0 2.5
print(floor(2.7), floor(-2.5), floor(3), sqrt(9), sqrt(2.25));  // prints: 2 -3 3 3.0 1.5
print(sin(0), cos(0), sum([0.5, 1]));   // prints: 0.0 1.0 1.5
n = range(1, 3);
return n * 0.5;
// expect: 0.5
// expect: 1.0
// expect: 1.5
