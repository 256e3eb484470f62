// Sites in exclusive branches share their label, so a choice keeps its address whichever of them is taken.
if flip() { x = range(0, 1); } else { x = range(0, 1); y = flip(); }
x = range(0, 1);
// expect solutions: 12
// expect choice: x = 1
// expect choice: x#2 = 1
// expect choice: y = false
