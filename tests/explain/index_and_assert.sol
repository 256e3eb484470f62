// An index that is in the list only where an assert fails.
x = range(0, 9);
prices = [10, 20, 30];
total = prices[x] + 5;  // conflict: the list must have such an element
assert(x >= 3, "the first three are sold");  // conflict: x >= 3
