// What is in the list.
i = range(0, 2);
prices = [10, 20, 30];
assert(prices[i] > 30);  // conflict: prices[i] > 30
