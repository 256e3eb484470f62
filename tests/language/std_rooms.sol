import "std/layout.sol";
import "std/rooms.sol";
a, b = Rect(0, 0, 3, 2), Rect(3, 0, 2, 2);
site = Rect(0, 0, 5, 2);
door = door_between(a, b);
window = window_of(b, site, 2);
chair = Thing("chair", 1, 1, range(0, 3), 0, range(0, 1));
assert(fills([a, b], site) and way_is_free(door, [chair]) and usable(chair, [chair]));
assert(inside(front(chair, 1), a) and window.x == 3);
fixed = Thing("door", 1, 1, 3, 4, 0);   // a door that is a thing: in the wall on the right
assert(way_is_free(fixed, [Rect(3, 1, 1, 1)]) and not way_is_free(fixed, [Rect(3, 0, 1, 1)]));
assert(not way_is_free(fixed, [Rect(5, 0, 1, 1)]) and way_is_free(fixed, [Rect(4, 1, 1, 1)]));
assert(swing(door, 2) == Rect(1, door.y, 4, 1) and turned(door));
output {
  show_rooms([a, b], height: 2);
  show_opening(door);
  show_opening(window);
}
// expect solutions: 16
// expect: nil
