print([x * x for x in 1..4]);                                // prints: [1, 4, 9, 16]
print([x for x in 1..9 if x % 2 == 0 if x > 3]);             // prints: [4, 6, 8]
print([[x, y] for x in 0..2 for y in x..2 if x != y]);       // prints: [[0, 1], [0, 2], [1, 2]]
print([a + b for a, b in zip([1, 2], [10, 20])]);            // prints: [11, 22]
print([[y for y in 0..x] for x in 0..2]);                    // prints: [[0], [0, 1], [0, 1, 2]]
print([x for x in []], [1 for i in 3..1]);                   // prints: [] []
x = "outer";
print([x for x in [1]], x);                                  // prints: [1] outer
print([if x > 1 then "b" else "s" for x in 1..2]);           // prints: ["s", "b"]
print([x for x in [y for y in 0..3 if y > 0] if x < 3]);     // prints: [1, 2]
