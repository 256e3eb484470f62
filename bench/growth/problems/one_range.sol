// n solutions of one choice.
param n = 1000;
x = range(1, n);
return x;
