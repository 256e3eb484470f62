s = range(1, 2);
x = range(0, 4, s);
return x;
