// Rooms that share walls, doors and windows in these, and the room that things need to be used.
//
// A room is a rectangle of std/layout.sol. Rooms that touch have one wall between them, on the line where they meet.
import "std/layout.sol";

// An opening in a wall: from (x, y) on, w long, to the right or, with turn 1, along y. It is a thing of std/layout.sol without
// depth.
record Opening(kind, x, y, w, d = 0, turn = 0);

// Chooses where a door, or another opening, stands in the wall between two rooms. It rules out rooms that share no wall that
// is so long.
fun door_between(a, b, w = 1, kind = "door") {
  upwards = any(x2(a) == x1(b), x2(b) == x1(a));
  behind = any(y2(a) == y1(b), y2(b) == y1(a));
  assert(upwards or behind, "rooms with a door between them touch");
  at = range(cond(upwards, max(y1(a), y1(b)), max(x1(a), x1(b))), cond(upwards, min(y2(a), y2(b)), min(x2(a), x2(b))) - w);
  along = cond(upwards, cond(x2(a) == x1(b), x1(b), x1(a)), cond(y2(a) == y1(b), y1(b), y1(a)));
  return Opening(kind, cond(upwards, along, at), cond(upwards, at, along), w, turn: cond(upwards, 1, 0));
}

// Chooses where a window, or a door to the outside, stands in a wall of r that lies on the outline of `site`.
fun window_of(r, site, w = 1, kind = "window") {
  side = range(0, 3);                              // front, right, back, left
  upwards = side == 1 or side == 3;
  assert(cond(side == 0, y1(r) == y1(site), cond(side == 1, x2(r) == x2(site),
         cond(side == 2, y2(r) == y2(site), x1(r) == x1(site)))), "a window looks out");
  at = range(cond(upwards, y1(r), x1(r)), cond(upwards, y2(r), x2(r)) - w);
  line = cond(side == 0, y1(r), cond(side == 1, x2(r), cond(side == 2, y2(r), x1(r))));
  return Opening(kind, cond(upwards, line, at), cond(upwards, at, line), w, turn: cond(upwards, 1, 0));
}

// The free space that an opening, or a door that is a thing, needs before and behind it.
fun swing(o, reach = 1) {
  return Rect(o.x - cond(turned(o), reach, 0), o.y - cond(turned(o), 0, reach),
              width(o) + cond(turned(o), 2 * reach, 0), depth(o) + cond(turned(o), 0, 2 * reach));
}

// Nothing stands in the way of an opening or a door.
fun way_is_free(o, things, reach = 1) { return lists_apart([swing(o, reach)], things); }

// The space before o's front is free, so that one can sit down, or open it.
fun usable(o, things, reach = 1) { return lists_apart([front(o, reach)], things); }

// Every place of the site belongs to one of the rooms: together they are as large, and they do not overlap.
fun fills(rooms, site) {
  return all(all_apart(rooms), all([inside(r, site) for r in rooms]),
             sum([width(r) * depth(r) for r in rooms]) == width(site) * depth(site));
}

// ---- showing; in the output, where it costs the solver nothing

// The floors of the rooms, and a wall on each line where one of them ends.
fun show_rooms(rooms, thickness = nil, height = nil, material = "plaster") {
  if thickness == nil then thickness = wall_thickness();
  for r in rooms: show_floor(r);
  lying = [[y, x] for r in rooms for y in [y1(r), y2(r)] for x in x1(r)..x2(r) - 1];
  standing = [[x, y] for r in rooms for x in [x1(r), x2(r)] for y in y1(r)..y2(r) - 1];
  for line, from, long in runs(lying) {
    show_piece([from - thickness / 2.0, line - thickness / 2.0], long + thickness, thickness, 0, height, material);
  }
  for line, from, long in runs(standing) {
    show_piece([line - thickness / 2.0, from - thickness / 2.0], long + thickness, thickness, 1, height, material);
  }
}

fun show_piece(at, long, thickness, turn, height, material) {
  place("wall", at: at, size: if height == nil then [long, thickness] else [long, thickness, height], turn: turn, material: material);
}

// Pieces of length 1, each a line and a position on it, joined to the longest: [line, from, length].
fun runs(pieces) {
  made = [];
  for line, at in pieces {
    if [line, at - 1] not in pieces {
      long = 1;
      while [line, at + long] in pieces: long += 1;
      if [line, at, long] not in made then made = made + [[line, at, long]];
    }
  }
  return made;
}

// A door or window, which opens the wall that it stands in.
fun show_opening(o, thickness = nil) {
  if thickness == nil then thickness = wall_thickness();
  out = thickness / 2.0 + frame_depth();
  place(o.kind, at: if turned(o) then [o.x - out, o.y] else [o.x, o.y - out], size: [o.w, 2 * out], turn: o.turn);
}
