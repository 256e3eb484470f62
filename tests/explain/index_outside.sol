// An index that is never in the list.
x = range(3, 5);  // conflict: x is at least 3
prices = [10, 20, 30];
return prices[x];  // conflict: the list must have such an element
