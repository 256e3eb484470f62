// A chosen index into a long list, and into a part of it.
xs = [(i * 7919) % 1009 for i in 0..999];
i = range(0, 999);
assert(xs[i] == 500 or i >= 990 and xs[i - 690] % 10 < 3);
return [i, xs[i]];
// expect: [920, 500]
// expect: [991, 736]
// expect: [994, 277]
// expect: [997, 827]
