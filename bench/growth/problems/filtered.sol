// What functions say of a list of which each of n numbers is in it or not.
param n = 50;
xs = [range(0, 999) for i in 1..n if flip()];
assert(length(xs) > n / 3 and distinct(xs));
assert(max(xs) - min(xs) > 500 and first(xs) < last(xs));
steps = [p[1] - p[0] for p in zip(xs, cdr(xs))];
assert(max(steps) > 100);
return length(xs);
