// Rooms of these widths do not fit along the corridor.
param length_of_corridor = 10;

fun make_room(least) {
  w = range(least, 6);
  // conflict: make_room/w is at least 3; make_room#2/w is at least 4; make_room#3/w is at least 5
  assert(w >= least, "wide enough for its use");
  return w;
}
widths = [make_room(3), make_room(4), make_room(5)];
assert(sum(widths) <= length_of_corridor, "the rooms fit along the corridor");
// conflict: sum(widths) <= length_of_corridor
