// Two desks back to back and an aisle on either side are deeper than the room.
import "std/layout.sol";

param aisle = 2;
room = Rect(0, 0, 8, 6);
desks = [Thing("desk", 4, 2, 0, 2, range(0, 6)) for i in 1..2];
for desk in desks: assert(inside(desk, room, margin: aisle), "one can walk around the desks");
// conflict: inside(desk, room, margin: aisle) @ assert[0]; inside(desk, room, margin: aisle) @ assert[1]
assert(apart(desks[0], desks[1]), "desks do not overlap");  // conflict: apart(desks[0], desks[1])
assert(desks[0].y != 1);
