// Shows: a house of bricks: every layer is full, and every brick holds two bricks of the layer below together.
import "std/layout.sol";

param size = 4;       // in studs, square
param layers = 4;
param bricks = 4;     // in a layer

record Brick(x, y, w, d, turn, color);
base = Rect(0, 0, size, size);
fun brick() {
  w, d = choose([[2, 2], [3, 2], [4, 2], [2, 1], [3, 1], [4, 1]]);
  return Brick(range(0, size - 1), range(0, size - 1), w, d, range(0, 1), choose(["red", "blue", "yellow", "green"]));
}
fun make_layer() {
  layer = [brick() for i in 1..bricks];
  assert(all([inside(b, base) for b in layer]) and all_apart(layer));
  assert(sum([b.w * b.d for b in layer]) == size * size, "the layer is full");
  assert(all([not touching(a, b) or a.color != b.color for a, b in pairs(layer)]), "neighbours differ in colour");
  return layer;
}
tower = [make_layer() for i in 1..layers];
for below, above in zip(tower, cdr(tower)) {
  for b in above: assert(count([overlap_x(a, b) and overlap_y(a, b) for a in below]) >= 2, "it holds two together");
}

unit(0.008);
output {
  for y in [-2, 2]: place("plate_8x4", at: [-2, y, -0.4], color: "green");
  for y in 0..size - 1 {
    if y % 2 == 0 then place("slope_4x2", at: [0, y, 1.2 * layers], turn: if y < size / 2 then 0 else 2, color: "maroon");
  }
  for i, layer in enumerate(tower) {
    for b in layer {
      place(str("brick_", b.w, "x", b.d), at: [b.x, b.y, 1.2 * i], turn: b.turn, color: b.color);
    }
  }
}
