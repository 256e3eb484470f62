// One element is left whatever x is, but which one is chosen.
x = range(0, 1);
list = [u for u in [1, 2] if u == x + 1];
list[x] = 5;
return x, list;
