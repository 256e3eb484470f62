// Whichever function is chosen.
fun double(x) { assert(x > 3); return 2 * x; }  // conflict: x > 3 @ f#2/assert
fun triple(x) { assert(x > 4); return 3 * x; }  // conflict: x > 4 @ f#2/assert
f = choose([double, triple]);
x = range(0, 3);  // conflict: x is at most 3
return f(x);
