// A function sees the variables around it as they are when it is called, also where choices decided them.
limit = 1;
fun low(x) { return x <= limit; }
if flip() { limit = 3; }
x = range(0, 4);
assert(low(x));
return [limit, x];
// expect: [1, 0]
// expect: [1, 1]
// expect: [3, 0]
// expect: [3, 1]
// expect: [3, 2]
// expect: [3, 3]
