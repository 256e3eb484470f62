// What stands in an assignment is evaluated once: the values, then the indices of each target, from left to right.
record Box(items);
fun noted(x, text) { print(text); return x; }
xs = [[1, 2], [3, 4]];
xs[noted(1, "row")][noted(0, "column")] = noted(7, "value");   // prints: value
                                                                // prints: row
                                                                // prints: column
b = Box([Box([0, 0]), Box([0, 0])]);
b.items[noted(0, "outer")].items[noted(1, "inner")] += noted(5, "amount");   // prints: amount
                                                                             // prints: outer
                                                                             // prints: inner
xs[noted(0, "first")][0], xs[noted(0, "second")][1] = noted(8, "eight"), noted(9, "nine");   // prints: eight
                                                                                             // prints: nine
                                                                                             // prints: first
                                                                                             // prints: second
ys = [[0, 0], [0, 0]];
ys[range(0, 1)][range(0, 0)] = 1;   // expect choice: range = 1
                                    // expect choice: range#2 = 0
return xs, b.items[0].items, ys;
// expect: [[[8, 9], [7, 4]], [0, 5], [[1, 0], [0, 0]]]
// expect: [[[8, 9], [7, 4]], [0, 5], [[0, 0], [1, 0]]]
