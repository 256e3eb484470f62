// forbid: x=1
// forbid: x=2
// forbid: x=3
x = range(1, 3);
// conflict: x is at least 1; x is at most 3; x is not 1, by --forbid 'x=1'; x is not 2, by --forbid 'x=2'
// conflict: x is not 3, by --forbid 'x=3'
return x;
