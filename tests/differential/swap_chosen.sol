a = [1, 2, 3];
i = range(0, 2); j = range(0, 3);
a[i], a[j] = a[j], a[i];
a[a[i] - 1] += a[0];
return a;
