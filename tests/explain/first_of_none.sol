// The first element of a list that is empty.
n = range(0, 2);
xs = [7 for i in 1..n];
assert(n == 0);  // conflict: n == 0
return car(xs);  // conflict: the list must have such an element
