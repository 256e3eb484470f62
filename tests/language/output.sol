// The output runs for solutions only, with plain values.
x = range(0, 3);
xs = [x, 2];
print("found", x);
assert(x != 1);
return "not seen";
output {
  half = x / 2.0;
  fun shown(y) { if y > 0.7 then return "much"; return "little"; }
  if half > 0.7 then print("more"); else print("less");
  xs[0] = 7;
  place("chair", at: [half, 0], name: shown(half));
  return half, shown(half), sort(xs), 2 in xs;
}
// expect: [0.0, "little", [2, 7], true]
// expect: [1.0, "much", [2, 7], true]
// expect: [1.5, "much", [2, 7], true]
