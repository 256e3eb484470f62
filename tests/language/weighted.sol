// Weights and probabilities say nothing about what is possible, not even a weight of 0.
x = choose(["a", "b"], weights: [1, 3]);
i = categorical([0, 2, 1]);
f = flip(0.25);
return x, i, f;
// expect solutions: 12
// expect: ["a", 0, false]
// expect: ["b", 2, true]
// expect choice: i = 2
