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

output {
  show_room(room);
  show_in_wall(Thing("double_door", 4, 1, 2, door.x, 0), room);
  for p in places {
    seats = length(p.chairs);
    kind = if seats == 2 then "dining_table" else "dining_table_four";
    place(kind, at: [p.table.x, p.table.y], size: [p.table.w, p.table.d], turn: p.table.turn);
    for i in 0..seats - 1 {
      chair = in_frame(p.table, "restaurant_chair", if seats == 2 then 0.5 else 0.4 + 2.2 * (i % 2), if i < seats / 2 then -0.75 else 1.75, 1, 1, if i < seats / 2 then 2 else 0);
      show(chair);
    }
  }
  for x in [0.3, side - 1.3] { place("plant", at: [x, side - 1.3], size: [1, 1]); }
  print(format("{} seats", sum([length(p.chairs) for p in places])));
}
