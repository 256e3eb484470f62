// Ends that depend on choices, steps, and ends that leave one value.
a = range(1, 3);
b = range(a, 2 * a, 2);
c = range(5, 5);
return [a, b, c];
// expect: [1, 1, 5]
// expect: [2, 2, 5]
// expect: [2, 4, 5]
// expect: [3, 3, 5]
// expect: [3, 5, 5]
