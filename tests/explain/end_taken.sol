// The end alone, whatever the range that it depends on.
n = range(2, 4);  // conflict: n is at most 4
m = range(n, 9);  // conflict: m is not below its range
assert(m < n);  // conflict: m < n
