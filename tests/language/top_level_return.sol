x = range(0, 2);
if x == 0 { return "early"; }
assert(x != 1);
return "late";
// expect: "early"
// expect: "late"
