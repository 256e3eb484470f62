// A list that was changed at a chosen place.
xs = [1, 2, 3];
i = range(0, 2);  // conflict: i is at least 0; i is at most 2
xs[i] = 0;
assert(xs[0] + xs[1] == 3 and i < 2);  // conflict: xs[0] + xs[1] == 3; i < 2
