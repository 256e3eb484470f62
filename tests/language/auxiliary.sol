// Solutions that differ in auxiliary choices alone are one, also where there are fewer choices on one path.
fun parity(x) { half = range(0, 3); return x == 2 * half; }
x = range(0, 6);
aux even = parity(x);
aux unused = range(0, 9);
assert(even);
if flip() { aux more = [flip(), flip()]; assert(more[0] or more[1]); }
return x;
// expect: 0
// expect: 0
// expect: 2
// expect: 2
// expect: 4
// expect: 4
// expect: 6
// expect: 6
