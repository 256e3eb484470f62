// n shelves in a shop, turned in any way. Before each is an aisle; those of shelves that face each other may be one.
import "std/layout.sol";
import "std/rooms.sol";
param n = 10;
param side = 16;
room = Rect(0, 0, side, side);
fun shelf() { return Thing("shelf", 4, 1, range(0, 3), range(0, side - 1), range(0, side - 1)); }
shelves = repeat(n, shelf);
for s in shelves {
  assert(inside(s, room) and inside(front(s, 2), room), "in the shop, with an aisle");
  assert(usable(s, shelves, 2), "the aisle is free");
}
assert(all_apart(shelves));
return n;
