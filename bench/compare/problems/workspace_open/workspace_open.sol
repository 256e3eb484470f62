// Workspaces of which it is chosen, too, how many groups there are and how many tables, chairs and sofas each has.
import "std/layout.sol";

param most_groups = 3;
param most_tables = 5;
param aisle = 3;

most = 24 + 10 * most_groups;   // no room is wider or deeper

fun make_table() { return anywhere("table", 6, 3, most, most); }
fun make_chair() { return anywhere("chair", 2, 2, most, most); }
fun make_sofa() { return anywhere("sofa", 6, 3, most, most); }

fun make_group() {
  tables = repeat(range(1, most_tables), make_table);
  chairs = repeat(range(2, most_tables + 1), make_chair);
  sofas = repeat(range(1, 3), make_sofa);
  assert(length(tables) < length(chairs), "more chairs than tables");
  assert(column(tables), "the tables form a larger one");
  for table in tables: assert(table.turn == tables[0].turn);
  for seats in [chairs, sofas] {
    for seat in seats: assert(any([facing(seat, table) for table in tables]), "each seat faces a table");
  }
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
for group in groups {
  for kind in group {
    for o in kind: assert(inside(o, room));
  }
}
return room.w, room.d;
