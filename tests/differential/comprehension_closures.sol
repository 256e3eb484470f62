// A function that reads a comprehension's variable sees what it was last, which depends on how many turns there were.
n = range(0, 2);
fs = [fun() { return u; } for u in 0..n];
gs = [fun(x) { return x * w; } for v in 1..n + 1 if v != 2 for w in 0..v];
h = if n > 0 then [fun() { return y; } for y in 0..n - 1][0] else fun() { return 7; };
ok = n == 2 and [fun() { return z; } for z in fs][0]()() == 2;
assert(fs[0]() == n and not flip() or flip());
return [fs[0]() + 10 * gs[0](1), h(), ok];
