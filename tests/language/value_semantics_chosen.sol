// A change under a chosen condition, or at a chosen place, changes no other holder either.
a = [[0, 0], [0, 0]];
b = a;
if flip() { a[0][1] = 1; }
a[range(0, 1)][0] = 5;
return [a, b];
// expect: [[[5, 0], [0, 0]], [[0, 0], [0, 0]]]
// expect: [[[0, 0], [5, 0]], [[0, 0], [0, 0]]]
// expect: [[[5, 1], [0, 0]], [[0, 0], [0, 0]]]
// expect: [[[0, 1], [5, 0]], [[0, 0], [0, 0]]]
