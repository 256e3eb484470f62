x = range(0, 3);
place("box", color: if x < 2 then "red" else [x - 2, 0, 0]);
place("box", color: [0, x, 0], at: [x, if x == 0 then 1.5 else 2]);
assert(x < 2);
