// A condition in a function that was passed.
fun each(xs, check) { for x in xs { check(x); } }
limit = range(3, 5);  // conflict: limit is at most 5
each([1, 4, 9], fun(x) { assert(x < limit); });  // conflict: x < limit @ each/check[2]/assert
