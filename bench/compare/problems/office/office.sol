// Buildings: halls that meet in a chain or a ring, and along them groups of offices in a row, all on a grid of 4.
import "std/layout.sol";

param halls = 4;
param ring = true;
param groups = 4;    // dealt out to the halls one after the other
param offices = 4;   // in each group

grid = 4;
most = grid * (5 * halls + 8);   // the site is that long and that deep

fun anywhere_on_grid() { return [range(0, most, grid), range(0, most, grid)]; }

fun make_hall(along_y) {
  length = range(16, 40, grid);
  x, y = anywhere_on_grid();
  return Rect(x, y, cond(along_y, grid, length), cond(along_y, length, grid));
}

fun make_office(turn) {
  w = choose([4, 8]);
  x, y = anywhere_on_grid();
  return Rect(x, y, w, 8, turn);
}

fun make_group(hall) {
  turn = range(0, 3);
  row = [make_office(turn) for i in 1..offices];
  for office in row: assert(facing(office, hall), "the door is to the hall");
  for i in 0..offices - 2 {
    assert(cond(turned(row[i]), y2(row[i]) == y1(row[i + 1]), x2(row[i]) == x1(row[i + 1])), "side by side");
  }
  return row;
}

turned_first = flip();
building = [make_hall(turned_first == (i % 2 == 0)) for i in 0..halls - 1];
closes = ring and halls > 2;
for i in 0..halls - 1 {
  for j in i + 1..halls - 1 {
    neighbours = j == i + 1 or (closes and i == 0 and j == halls - 1);
    if neighbours then assert(touching(building[i], building[j], grid), "halls meet");
    else assert(apart(building[i], building[j], 2 * grid), "a courtyard between halls");
  }
}

rows = [make_group(building[i % halls]) for i in 0..groups - 1];
rooms = [office for row in rows for office in row];
assert(all_apart(building + rooms));

site = Rect(0, 0, most, most);
for o in building + rooms: assert(inside(o, site));
return turned_first;
