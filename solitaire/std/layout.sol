// Layouts of boxes on a floor plan: x runs right, y into the depth, in whole units.
//
// A thing is any record with the fields x, y (its lowest corner), w, d (its size before turning) and turn (quarter
// turns counter-clockwise seen from above). Rect and Thing below are such records; your own work as well.
// A thing that is not turned has its front towards -y; turn 1 faces +x, turn 2 faces +y, turn 3 faces -x.
//
// Functions that answer a question return a bool, for assert to use: assert(apart(a, b)).

record Rect(x, y, w, d, turn = 0);
record Thing(kind, w, d, turn, x, y);

// ---- extents, after turning. Written out, and not each by the one before, for they are asked of all pairs of things.

fun turned(o) { return o.turn == 1 or o.turn == 3; }
fun width(o) { return cond(o.turn == 1 or o.turn == 3, o.d, o.w); }   // along x
fun depth(o) { return cond(o.turn == 1 or o.turn == 3, o.w, o.d); }   // along y
fun x1(o) { return o.x; }
fun y1(o) { return o.y; }
fun x2(o) { return o.x + cond(o.turn == 1 or o.turn == 3, o.d, o.w); }
fun y2(o) { return o.y + cond(o.turn == 1 or o.turn == 3, o.w, o.d); }

// ---- where two things are

// o lies in r, at least `margin` from its edges.
fun inside(o, r, margin = 0) {
  return all(x1(r) + margin <= x1(o), x2(o) + margin <= x2(r), y1(r) + margin <= y1(o), y2(o) + margin <= y2(r));
}

// The two do not overlap, and there is at least `gap` between them.
fun apart(a, b, gap = 0) {
  return any(x2(a) + gap <= b.x, x2(b) + gap <= a.x, y2(a) + gap <= b.y, y2(b) + gap <= a.y);
}

// No two of the list overlap, and there is at least `gap` between them.
fun all_apart(things, gap = 0) {
  return boxes_apart([[[o.x, x2(o)], [o.y, y2(o)]] for o in things], gap);
}

// No thing of one list overlaps one of the other.
fun lists_apart(these, those, gap = 0) {
  return all([all([apart(a, b, gap) for b in those]) for a in these]);
}

fun overlap_x(a, b, least = 1) { return all(x1(a) + least <= x2(b), x1(b) + least <= x2(a)); }
fun overlap_y(a, b, least = 1) { return all(y1(a) + least <= y2(b), y1(b) + least <= y2(a)); }

// They share at least `least` of an edge.
fun touching(a, b, least = 1) {
  beside = any(x2(a) == x1(b), x2(b) == x1(a));
  behind = any(y2(a) == y1(b), y2(b) == y1(a));
  return any(all(beside, overlap_y(a, b, least)), all(behind, overlap_x(a, b, least)));
}

// They share a whole edge, so that together they are one larger rectangle.
fun joined(a, b) {
  beside = all(any(x2(a) == x1(b), x2(b) == x1(a)), y1(a) == y1(b), y2(a) == y2(b));
  behind = all(any(y2(a) == y1(b), y2(b) == y1(a)), x1(a) == x1(b), x2(a) == x2(b));
  return any(beside, behind);
}

// a stands right in front of b, `gap` away, facing it, and its front is not wider than the edge of b that it faces.
fun facing(a, b, gap = 0) {
  along_x = all(x1(b) <= x1(a), x2(a) <= x2(b));
  along_y = all(y1(b) <= y1(a), y2(a) <= y2(b));
  return any(
    all(a.turn == 0, y1(a) == y2(b) + gap, along_x),
    all(a.turn == 1, x2(a) + gap == x1(b), along_y),
    all(a.turn == 2, y2(a) + gap == y1(b), along_x),
    all(a.turn == 3, x1(a) == x2(b) + gap, along_y));
}

// o stands in r with its back to a wall of r.
fun flush(o, r) {
  return all(inside(o, r), any(
    all(o.turn == 0, y2(o) == y2(r)),
    all(o.turn == 1, x1(o) == x1(r)),
    all(o.turn == 2, y1(o) == y1(r)),
    all(o.turn == 3, x2(o) == x2(r))));
}

// The free space of a depth that o needs at its front.
fun front(o, reach) {
  return Rect(
    cond(o.turn == 1, x2(o), cond(o.turn == 3, x1(o) - reach, x1(o))),
    cond(o.turn == 2, y2(o), cond(o.turn == 0, y1(o) - reach, y1(o))),
    cond(turned(o), reach, width(o)),
    cond(turned(o), depth(o), reach));
}

// ---- rows and grids

// Each thing of the list touches the next one to its right, their lower edges on one line.
fun row(things) {
  return all([all(x2(things[i]) == x1(things[i + 1]), y1(things[i]) == y1(things[i + 1]))
              for i in 0..length(things) - 2]);
}

// The same upwards, their left edges on one line.
fun column(things) {
  return all([all(y2(things[i]) == y1(things[i + 1]), x1(things[i]) == x1(things[i + 1]))
              for i in 0..length(things) - 2]);
}

// Position and size are multiples of `step`.
fun on_grid(o, step) { return all(o.x % step == 0, o.y % step == 0, o.w % step == 0, o.d % step == 0); }

// ---- a thing in the frame of another

// A thing of size w x d that stands in o: u to the right of o's left front corner, seen from inside of o towards its
// front's opposite, v behind its front; turned by `turn` against o. It moves and turns with o.
fun in_frame(o, kind, u, v, w, d, turn = 0) {
  swapped = turn == 1 or turn == 3;
  along = cond(swapped, d, w);
  deep = cond(swapped, w, d);
  x = cond(o.turn == 0, u, cond(o.turn == 1, o.d - v - deep, cond(o.turn == 2, o.w - u - along, v)));
  y = cond(o.turn == 0, v, cond(o.turn == 1, u, cond(o.turn == 2, o.d - v - deep, o.w - u - along)));
  return Thing(kind, w, d, (o.turn + turn) % 4, o.x + x, o.y + y);
}

// ---- around several things

fun bounds(things) {
  left = min([x1(o) for o in things]);
  low = min([y1(o) for o in things]);
  return Rect(left, low, max([x2(o) for o in things]) - left, max([y2(o) for o in things]) - low);
}

// ---- making things

// [make(), make(), ...], n of them; n may be chosen.
fun repeat(n, make) { return [make() for i in 1..n]; }

// A thing of that kind and size anywhere within 0..most_x, 0..most_y, turned in any way.
fun anywhere(kind, w, d, most_x, most_y) {
  turn = range(0, 3);
  x, y = range(0, most_x), range(0, most_y);
  return Thing(kind, w, d, turn, x, y);
}

// ---- showing things

fun show(o) { place(o.kind, at: [o.x, o.y], size: [o.w, o.d], turn: o.turn); }

fun show_all(things) { for o in things: show(o); }

// Walls are as thick as in a house, 12 cm, if nothing else is said, and frames of doors stand out by 12 mm.
fun wall_thickness() { return 0.12 / unit(); }
fun frame_depth() { return 0.012 / unit(); }

// A door or window that is flush to a wall of r, moved into the wall behind it, which it opens. It is a little thicker than
// the wall.
fun show_in_wall(o, r, thickness = nil) {
  if thickness == nil then thickness = wall_thickness();
  frame = frame_depth();
  out = thickness + frame;
  x = cond(o.turn == 1, r.x - out, cond(o.turn == 3, x2(r) - frame, o.x));
  y = cond(o.turn == 2, r.y - out, cond(o.turn == 0, y2(r) - frame, o.y));
  place(o.kind, at: [x, y], size: [o.w, out + frame], turn: o.turn);
}

// A floor whose upper side is at height 0, so that a rug lies on it.
fun show_floor(r) {
  place("floor", at: [r.x, r.y, 0 - size_of("floor")[2] / unit()], size: [width(r), depth(r)], name: "floor");
}

// A floor and four walls around r; the walls stand outside of it. Without a height they are as high as in a house.
fun show_room(r, thickness = nil, height = nil) {
  if thickness == nil then thickness = wall_thickness();
  show_floor(r);
  long = width(r) + 2 * thickness;
  show_wall([r.x - thickness, y2(r)], long, thickness, height, 0, "back wall");
  show_wall([r.x - thickness, r.y - thickness], long, thickness, height, 0, "front wall");
  show_wall([r.x - thickness, r.y], depth(r), thickness, height, 1, "left wall");
  show_wall([x2(r), r.y], depth(r), thickness, height, 1, "right wall");
}

fun show_wall(at, long, thickness, height, turn, name) {
  size = [long, thickness];
  if height != nil then size = size + [height];
  place("wall", at: at, size: size, turn: turn, name: name);
}
