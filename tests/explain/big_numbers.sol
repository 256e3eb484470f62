// Near the largest ints.
x = range(4600000000000000000, 4600000000000000005);  // conflict: x is at most 4600000000000000005
y = range(0, 3);
assert(x - 4600000000000000000 > y + 4);  // conflict: x - 4600000000000000000 > y + 4
assert(y > 1);  // conflict: y > 1
