// Keys of a list whose length depends on choices: each element has one where the list has the element, and may choose for it.
a, b, c = range(0, 1), range(1, 2), range(1, 2);
xs = [x for x in [a, b, c] if x != 1];
assert(length(xs) > 0);
noisy = fun(x) { return x + range(0, 3, step: 3); };
near = if contains(xs, 0) then 0 else max(xs, key: fun(x) { return 1 / x; });
return [xs, sort(xs, noisy), min(xs, key: noisy), near];
// expect solutions: 124
// expect: [[0, 2, 2], [0, 2, 2], 0, 0]
