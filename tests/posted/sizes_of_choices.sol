// That a corridor is longer than nothing follows from the conditions on its rooms.
// $ generate -n 2
// says: 2 solutions
import "std/layout.sol";
param n = 4;
param size = 20;
rooms = [Rect(range(0, size), range(0, size), range(3, 6), range(3, 6)) for i in 1..n];
for r in rooms: assert(inside(r, Rect(0, 0, size, size)));
assert(all_apart(rooms, 1));
fun pick(i) { return range(0, i - 1); }
for i in 1..n - 1 {
  a, b = rooms[pick(i)], rooms[i];
  assert(overlap_y(a, b) and x2(a) <= x1(b));
  place("corridor", at: [x2(a), max(a.y, b.y)], size: [x1(b) - x2(a), 1]);
}
