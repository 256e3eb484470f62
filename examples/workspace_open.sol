// Shows: an open world, where it is chosen how many things there are.
//
// One to three groups; each has one to five tables in a row that form one larger table, more seats than tables (two to
// six chairs and one to three sofas), and every seat faces a table of its group. The program never says which numbers
// go together: the asserts do. Where the door is depends on all of them.
import "std/layout.sol";

param most_groups = 3;
param aisle = 3;

unit(0.25);
legs = 2;                     // half a metre between a sofa and a table, by which one comes in, too
most = 24 + 10 * most_groups;   // no room is wider or deeper

fun make_table() { return anywhere("table", 6, 3, most, most); }
fun make_chair() { return anywhere("chair", 2, 2, most, most); }
fun make_sofa() { return anywhere("sofa", 6, 3, most, most); }

fun make_group() {
  tables = repeat(range(1, 5), make_table);
  chairs = repeat(range(2, 6), make_chair);
  sofas = repeat(range(1, 3), make_sofa);
  assert(length(tables) < length(chairs), "more chairs than tables");
  assert(column(tables), "the tables form a larger one");
  for table in tables: assert(table.turn == tables[0].turn);
  for chair in chairs: assert(any([facing(chair, table) for table in tables]), "each chair faces a table");
  for sofa in sofas: assert(any([facing(sofa, table, legs) for table in tables]), "and each sofa, with room for legs");
  ways = [front(sofa, legs) for sofa in sofas];
  assert(lists_apart(ways, chairs) and lists_apart(ways, sofas), "nothing stands between a sofa and its table");
  // Lists of chosen lengths are best kept apart: joined into one, nobody could say which thing is the fifth.
  kinds = [tables, chairs, sofas];
  for kind in kinds: assert(all_apart(kind));
  for a, b in pairs(kinds): assert(lists_apart(a, b));
  return kinds;
}

groups = repeat(range(1, most_groups), make_group);
for a, b in pairs(groups) {
  for these in a {
    for those in b: assert(lists_apart(these, those, aisle), "there is a way between the groups");
  }
}

room = Rect(0, 0, range(12, most), range(12, most));
count = 0;
for group in groups {
  for kind in group {
    for o in kind: assert(inside(o, room, 2));
    count += length(kind);
  }
}
assert(room.w + room.d <= 22 + 3 * count / 2, "the room fits");
assert(room.w <= 2 * room.d and room.d <= 2 * room.w);

// The way in: a door in a wall and free floor before it.
door = anywhere("door", 4, 1, most, most);
assert(flush(door, room));
way_in = front(door, 5);
for group in groups {
  for kind in group: assert(lists_apart([way_in], kind));
}

show_room(room);
show_in_wall(door, room);
for group in groups {
  for kind in group: show_all(kind);
}
return [[length(kind) for kind in group] for group in groups];
