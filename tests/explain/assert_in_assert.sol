// An assert in a function that an assert calls.
fun fits(x) { assert(x > 2, "not too small"); return x < 9; }  // conflict: x > 2 @ fits/assert
x = range(0, 9);
assert(fits(x) and x < 2, "fits");  // conflict: x < 2
