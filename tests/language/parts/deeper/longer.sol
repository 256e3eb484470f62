depth = range(1, 2);
length = range(5, 5);
