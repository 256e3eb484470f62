import "std/layout.sol";
import "std/rooms.sol";
a, b = Rect(0, 0, 3, 2), Rect(3, 0, 2, 2);
site = Rect(0, 0, 5, 2);
door = door_between(a, b);
window = window_of(b, site, 2);
chair = Thing("chair", 1, 1, range(0, 3), 0, range(0, 1));
assert(fills([a, b], site) and way_is_free(door, [chair]) and usable(chair, [chair]));
assert(inside(front(chair, 1), a) and window.x == 3);
output {
  show_rooms([a, b], height: 2);
  show_opening(door);
  show_opening(window);
}
// expect solutions: 16
// expect: nil
