// 300 elements, each of which may be missing: 2^300 lists, all but three of which are ruled out.
// only the solver: there are too many executions to run them all
xs = [];
for i in 1..300 {
  kept = flip();
  assert(kept or i < 3);
  if kept { xs = xs + [i]; }
}
assert(sum(xs) < 45150);
return length(xs), sum(xs), last(xs), 2 in xs;
// expect: [299, 45149, 300, true]
// expect: [299, 45148, 300, false]
// expect: [298, 45147, 300, false]
