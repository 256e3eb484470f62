// Workspaces: groups of two joined tables with a sofa and chairs at each, shelves and a whiteboard along the walls,
// an aisle between the groups. The room is as large as it needs to be, up to `most`.
import "std/layout.sol";

param groups = 3;
param most = 35;   // no room is wider or deeper
param aisle = 2;
param chairs = 2;   // at each table

fun make_group() {
  tables = [anywhere("table", 6, 3, most, most) for i in 1..2];
  assert(joined(tables[0], tables[1]), "the tables form a larger one");
  seats = [];
  for table in tables {
    sofa = anywhere("sofa", 6, 3, most, most);
    own = [sofa] + [anywhere("chair", 2, 2, most, most) for i in 1..chairs];
    for seat in own: assert(facing(seat, table), "each seat faces its table");
    seats = seats + own;
  }
  return tables + seats;
}

room = Rect(0, 0, range(8, most), range(8, most));
all_groups = [make_group() for i in 1..groups];
shelves = [anywhere("bookcase", 4, 1, most, most) for i in 1..groups];
whiteboard = anywhere("whiteboard", 7, 2, most, most);
along_walls = shelves + [whiteboard];

for group in all_groups {
  for o in group: assert(inside(o, room));
  assert(all_apart(group));
  assert(lists_apart(group, along_walls));
}
for a, b in pairs(all_groups): assert(lists_apart(a, b, aisle), "there is a way between the groups");
for o in along_walls: assert(flush(o, room));
assert(all_apart(along_walls));
return room.w, room.d;
