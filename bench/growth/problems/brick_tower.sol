// A tower of n layers of bricks. Each layer is full, and each brick holds two bricks below it together.
import "std/layout.sol";
param n = 4;
param size = 6;
record Brick(x, y, w, d, turn);
base = Rect(0, 0, size, size);
fun make_brick() {
  w, d = choose([[2, 2], [4, 2], [3, 2], [2, 1]]);
  return Brick(range(0, size - 1), range(0, size - 1), w, d, range(0, 1));
}
fun make_layer() {
  bricks = repeat(range(3, 9), make_brick);
  assert(all_apart(bricks));
  for b in bricks: assert(inside(b, base));
  assert(sum([b.w * b.d for b in bricks]) == size * size, "the layer is full");
  return bricks;
}
tower = [make_layer() for i in 1..n];
fun over(a, b) { return overlap_x(a, b) and overlap_y(a, b); }
for i in 1..n - 1 {
  for b in tower[i]: assert(count([over(b, c) for c in tower[i - 1]]) >= 2, "it holds two bricks together");
}
return n;
