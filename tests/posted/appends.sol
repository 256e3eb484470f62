// Each element is there or not.
// $ solve
// says: solution 1: 77
xs = [];
for i in 1..40 { if flip() { xs = xs + [range(0, 9)]; } }
assert(sum(xs) == 77);
return sum(xs);
