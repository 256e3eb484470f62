// Two elements are left whatever x is, but which ones is chosen.
x = range(0, 1);
list = [u for u in (if x < 1 then [4, -1] else [3, 1, 2]) if u != 3];
list[x] = 5;
return x, list;
