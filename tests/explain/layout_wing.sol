// In the second room of each wing the wardrobe is wider than the room.
import "std/layout.sol";

fun make_room(w) {
  room = Rect(0, 0, w, 3);
  wardrobe = Thing("cabinet", 3, 1, 0, range(0, 4), 1);
  assert(inside(wardrobe, room), "the wardrobe is in its room");
  // conflict 1: inside(wardrobe, room) @ make_wing[0]/make_room[1]/assert
  // conflict 2: inside(wardrobe, room) @ make_wing[1]/make_room[1]/assert
}
fun make_wing() {
  for w in [4, 2]: make_room(w);
}
for i in 1..2: make_wing();
