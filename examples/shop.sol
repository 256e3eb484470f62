// Shows: a shop: shelves in rows with aisles between them, the till at the door, what belongs together near each other.
import "std/layout.sol";
import "std/rooms.sol";

param width = 16;
param depth = 14;
param shelves = 6;

unit(0.5);
room = Rect(0, 0, width, depth);
goods = ["bread", "milk", "fruit", "drinks", "soap", "paper"];
colors = ["brown", "white", "green", "blue", "pink", "yellow"];

fun shelf(kind) { return Thing(kind, 5, 1, range(0, 3), range(0, width, 2), range(0, depth)); }
stand = [shelf(goods[i % 6]) for i in 0..shelves - 1];
till = Thing("till", 2, 1, 2, range(0, width - 2), 3);
door = Opening("door", width / 2 - 1, 0, 2);
things = stand + [till];

for o in things: assert(inside(o, room), "in the shop");
assert(all_apart(things, 1));
for o in stand: assert(usable(o, things, 3) and inside(front(o, 2), room), "an aisle before each shelf");
assert(way_is_free(door, things, 3), "a way in");
assert(abs(till.x - door.x) <= 4, "the till is at the door");
for i in [0, 2, 4] {
  a, b = stand[i], stand[i + 1];
  assert(abs(a.x - b.x) + abs(a.y - b.y) <= 8, "what belongs together");
}
prefer(count([flush(o, room) for o in stand]) >= 3, 2);

output {
  show_room(room);
  show_in_wall(Thing("door", 2, 1, 2, door.x, 0), room);
  for i, o in enumerate(stand) {
    for u in [0, 2.5] {
      part = in_frame(o, "shop_shelf", u, 0, 2.5, 1);
      place("shop_shelf", at: [part.x, part.y], size: [2.5, 1], turn: part.turn, color: colors[i % 6], name: o.kind);
    }
  }
  place("till", at: [till.x, till.y], size: [till.w, till.d], turn: till.turn);
}
