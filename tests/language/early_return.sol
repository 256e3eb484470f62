// Returns out of loops and branches under chosen conditions; what stands behind them only runs where nothing returned.
fun first_at_least(xs, least) {
  for x in xs {
    if x >= least { return x; }
  }
  return -1;
}
fun classify(n) {
  if n < 0 then return "negative";
  if n == 0 { return "zero"; }
  m = range(1, 2);
  if m > n then return "less";
  return "rest";
}
a = range(0, 3);
return [first_at_least([1, 4, 2], a * 2), classify(a - 1)];
// expect: [1, "negative"]
// expect: [4, "zero"]
// expect: [4, "rest"]
// expect: [4, "less"]
// expect: [-1, "rest"]
// expect: [-1, "rest"]
