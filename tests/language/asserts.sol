x = range(0, 9);
assert(x > 3, "large");
assert(condition: x < 7);
fun check(x) { assert(x != 5, "not " + str(5)); }
check(x);
if x == 6 { assert(false); }
return x;
// expect: 4
