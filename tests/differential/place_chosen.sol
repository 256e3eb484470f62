// Mistakes in what is placed are met before the assert behind them fails.
x = range(0, 3);
corner = 0;
if x == 2 { corner = "left"; }
place("box", at: [corner, x]);
assert(x < 2);
