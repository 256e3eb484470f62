// A chosen int may be compared with a known float: the condition is one on ints.
x = range(0, 4);
assert(x > 1.5 and x != 3.0 and x < 1e300);
y = range(0, 9) ;
assert(y >= 8.5 and 9.5 > y);
return [x, y, x == 2.0, 2.5 <= x];
// expect: [2, 9, true, false]
// expect: [4, 9, false, true]
