aux x = range(0, 5);
assert(x > 2);
return "one";
// expect: "one"
