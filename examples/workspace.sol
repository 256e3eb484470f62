// Shows: a furniture layout that no forward generator finds easily.
//
// Every group has two tables that form one larger table, and for each table two chairs and a sofa that face it, with room for legs and a way in. The
// room fits what stands in it. Bookcases, a whiteboard and plants stand flush to its walls, and the way in stays free.
// Try: --set groups=1 ... --set groups=6, and -n 50.
import "std/layout.sol";

param groups = 3;
param aisle = 3;    // what people need to walk: units between groups, and in front of bookcases

unit(0.25);
legs = 2;                 // half a metre between a sofa and its table, by which one comes in, too
most = 14 + 7 * groups;   // no room is wider or deeper

fun make_table() { return anywhere("table", 6, 3, most, most); }
fun make_chair() { return anywhere("chair", 2, 2, most, most); }
fun make_sofa() { return anywhere("sofa", 6, 3, most, most); }

fun make_group() {
  tables = [make_table() for i in 1..2];
  assert(joined(tables[0], tables[1]), "the tables form a larger one");
  seats = [];
  ways = [];
  for table in tables {
    chairs, sofa = [make_chair(), make_chair()], make_sofa();
    for chair in chairs: assert(facing(chair, table), "each chair faces its table");
    assert(facing(sofa, table, legs), "and each sofa, with room for legs");
    seats = seats + chairs + [sofa];
    ways = ways + [front(sofa, legs)];
  }
  assert(lists_apart(ways, seats), "nothing stands between a sofa and its table");
  return tables + seats;
}

all_groups = [make_group() for i in 1..groups];

room = Rect(0, 0, range(8, most), range(8, most));
for group in all_groups {
  assert(all_apart(group));
  for o in group: assert(inside(o, room, 2));   // nobody sits with the back against a wall
}
for a, b in pairs(all_groups): assert(lists_apart(a, b, aisle), "there is a way between the groups");

// The way in: a door in a wall and free floor before it.
door = anywhere("door", 4, 1, most, most);   // as if it stood in the room; shown in the wall behind it
assert(flush(door, room));
way_in = front(door, 5);
for group in all_groups: assert(lists_apart([way_in], group));

// What stands along the walls, with room to stand before it.
bookcases = [anywhere("bookcase", 4, 1, most, most) for i in 1..1 + groups];
whiteboard = anywhere("whiteboard", 7, 2, most, most);
plants = [anywhere("plant", 2, 2, most, most) for i in 1..2];
along_walls = bookcases + [whiteboard] + plants;
for o in along_walls: assert(flush(o, room));
assert(all_apart(along_walls + [door]));
assert(lists_apart([way_in], along_walls));
for group in all_groups: assert(lists_apart(along_walls, group));
for o in bookcases + [whiteboard]: assert(lists_apart([front(o, aisle)], along_walls));
for group in all_groups {
  for o in bookcases + [whiteboard]: assert(lists_apart([front(o, aisle)], group));
}

// The room fits what stands in it, and is not a corridor.
assert(room.w + room.d <= 30 + 9 * groups, "the room fits");
assert(room.w <= 2 * room.d and room.d <= 2 * room.w);

show_room(room);
for group in all_groups: show_all(group);
show_all(along_walls);
show_in_wall(door, room);
return room.w, room.d;
