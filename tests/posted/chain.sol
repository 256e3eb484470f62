// $ solve
// says: 1 solution
xs = [range(0, 9) for i in 1..2000];
for i in 0..1998 { assert(xs[i] != xs[i + 1]); }
return 1;
