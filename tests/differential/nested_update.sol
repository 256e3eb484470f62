a = [[1, 2], [3], 4];
i = range(-1, 3); j = range(0, 2);
a[i][j] = 9;
return a;
