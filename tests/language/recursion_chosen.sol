// Recursion whose depth is chosen, with no bound given.
fun tower(height) {
  if height == 0 then return [];
  return [range(1, 2)] + tower(height - 1);
}
t = tower(range(0, 3));
assert(sum(t) == 4);
return t;
// expect: [2, 2]
// expect: [1, 1, 2]
// expect: [1, 2, 1]
// expect: [2, 1, 1]
