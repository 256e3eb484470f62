// A float divided by a chosen int that can be zero.
s = range(-1, 2);
return [1.5 / s, 1.0 / 2];
