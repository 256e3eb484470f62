s = range(0, 2);
x = range(0, 4, s);
return x;
