// Shows: tables with their chairs, which a waiter comes to from every side.
import "std/layout.sol";

param tables = 4;
param side = 16;   // of the room, in half metres

record Place(table, chairs);
unit(0.5);
room = Rect(0, 0, side, side);
door = Rect(side / 2 - 2, 0, 4, 3);   // is kept free

fun make_place() {
  seats = choose([2, 4]);
  table = Thing("table", seats, 2, range(0, 1), range(0, side), range(0, side));
  chairs = [in_frame(table, "chair", i % (seats / 2) * 2, if i < seats / 2 then -1 else 2, 1, 1, if i < seats / 2 then 2 else 0)
            for i in 0..3 if i < seats];
  return Place(table, chairs);
}
fun whole(place) { return bounds([place.table] + place.chairs); }

places = [make_place() for i in 1..tables];
areas = map(whole, places);
for area in areas {
  assert(inside(area, room, 1), "a way along the walls");
  assert(apart(area, door), "a way in");
}
assert(all_apart(areas, 2), "a way between the tables");
assert(sum([length(p.chairs) for p in places]) == 3 * tables, "as many small tables as large ones");

show_room(room);
for p in places { show(p.table); show_all(p.chairs); }
output {
  print(format("{} seats", sum([length(p.chairs) for p in places])));
}
