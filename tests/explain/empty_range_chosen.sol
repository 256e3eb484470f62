// No value, whatever is chosen.
w = range(1, 3);
x = range(w + 3, w);  // conflict: there must be something to choose from
return x;
