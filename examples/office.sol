// Shows: a building of halls and offices, every part of which depends on all others.
//
// Halls meet in a chain or, with ring=true, in a ring. Along them stand groups of offices in a row, 4 x 8 or 8 x 8, all
// with their doors to the hall. Everything lies on a grid of 4. Courtyards come about by themselves.
//
//   --set halls=2 --set groups=2                    two halls in a chain, a group of four offices along each
//   --set halls=3 --set groups=3                    three
//   --set halls=4 --set groups=4 --set ring=true    four halls in a ring (the default)
import "std/layout.sol";

param halls = 4;
param ring = true;
param groups = 4;    // dealt out to the halls one after the other
param offices = 4;   // in each group

unit(0.5);
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

// A row of offices that face the hall, each next to the one before.
fun make_group(hall) {
  turn = range(0, 3);
  row = [make_office(turn) for i in 1..offices];
  for office in row: assert(facing(office, hall), "the door is to the hall");
  for i in 0..offices - 2 {
    assert(cond(turned(row[i]), y2(row[i]) == y1(row[i + 1]), x2(row[i]) == x1(row[i + 1])), "side by side");
  }
  return row;
}

// Each hall meets the next at a right angle; the others stay far enough away for a courtyard between them.
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

// ---- what it looks like

wall = 0.3;
fun wall_piece(office, u, v, w, d) { show(in_frame(office, "wall", u, v, w, d)); }

fun show_office(office) {
  place("floor", at: [office.x, office.y], size: [office.w, office.d], turn: office.turn);
  wall_piece(office, 0, office.d - wall, office.w, wall);
  wall_piece(office, 0, 0, office.w, wall);
  wall_piece(office, 0, wall, wall, office.d - 2 * wall);
  wall_piece(office, office.w - wall, wall, wall, office.d - 2 * wall);
  show(in_frame(office, "door", 0.8, 0 - 0.05, 1.8, wall + 0.1));   // opens the wall
  show(in_frame(office, "desk", wall, 4.6, 2.8, 1.4, 1));              // at the left wall
  show(in_frame(office, "office_chair", wall + 1.5, 5.4, 1.2, 1.2, 3));   // in the 1 m between desk and right wall
  if office.w == 8 {
    show(in_frame(office, "bookcase", 3.7, office.d - wall - 0.7, 2.6, 0.7));
    show(in_frame(office, "sofa", 6.0, 1.6, 3.6, 1.6, 3));
    show(in_frame(office, "plant", 6.4, office.d - wall - 1.1, 1.1, 1.1));
  }
}

for hall in building: place("floor", at: [hall.x, hall.y], size: [hall.w, hall.d], color: "beige", name: "hall");
for office in rooms: show_office(office);
return [[hall.w, hall.d] for hall in building];
