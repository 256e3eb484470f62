// An int and a float are compared as the numbers that they are, also where the int has no float of its own.
a = 9007199254740993;
b = 9007199254740992.0;
c = 9007199254740992;
print(a == b, b == c, a == c, distinct([a, b]), contains([a], b));  // prints: false true false true false
print(a > b, b < a, a <= b, b >= a, c >= b, c < b);                 // prints: true true false false true false
print(2 == 2.0, 2 < 2.5, 3 < 2.5, 2.5 <= 2, -3 < -2.5);             // prints: true true false false true
print(5 < 1e300, 5 > -1e300, 1e300 == 5);                           // prints: true true false
return 0;
// expect: 0
