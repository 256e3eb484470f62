// Sink, stove and fridge stand at one wall in this order, each with its door, and the corner is taken.
record Unit(x, w);

fun unit_of(w) { return Unit(range(0, 9), w); }
fun right_of(a, b) { return a.x + a.w <= b.x; }

sink = unit_of(3);
stove = unit_of(2);
fridge = unit_of(2);
for a, b in [[sink, stove], [stove, fridge]]: assert(right_of(a, b), "in this order");
// conflict: right_of(a, b) @ assert[0]; right_of(a, b) @ assert[1]
assert(sink.x >= 2, "the corner is taken");  // conflict: sink.x >= 2
assert(fridge.x + fridge.w <= 8 and fridge.x > 3, "within the wall");  // conflict: fridge.x + fridge.w <= 8
