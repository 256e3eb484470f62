// place and unit say nothing to the solver but may depend on choices.
unit(0.5);
x = range(0, 1);
place("table", at: [x, 1], size: [2, 1], turn: x, color: "brown", name: "t", owner: [x, "me"]);
if flip() { place(at: [x, 2.5, 1], size: [1, 1, 1], angle: 45); }
for i in 1..x { place(choose(["chair", "stool"]), at: [i, i], color: [0.5, 1, 0]); }
return x;
// expect: 0
// expect: 0
// expect: 1
// expect: 1
// expect: 1
// expect: 1
