// Asserts of functions that a comprehension calls.
fun least(x) { assert(x > 3); return x; }  // conflict: x > 3 @ least[0]/assert
xs = [least(range(0, i)) for i in 3..5 if i != 4];  // conflict: range[0] is at most 3
return xs;
