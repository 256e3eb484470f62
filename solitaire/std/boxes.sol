// Boxes in space: x runs right, y into the depth, z up, in whole units.
//
// A box is any record with the fields x, y, z (its lowest corner), w, d, h (its size before turning) and turn. Seen from
// above it is a thing of std/layout.sol.
import "std/layout.sol";

record Box(kind, x, y, z, w, d, h, turn = 0);

fun z1(o) { return o.z; }
fun z2(o) { return o.z + o.h; }

// o lies in r.
fun inside3(o, r) { return all(inside(o, r), r.z <= o.z, o.z + o.h <= r.z + r.h); }

// The two do not overlap, and there is at least `gap` between them beside, before or above.
fun apart3(a, b, gap = 0) { return any(apart(a, b, gap), z2(a) + gap <= b.z, z2(b) + gap <= a.z); }

// No two of the list overlap.
fun all_apart3(things, gap = 0) {
  return boxes_apart([[[o.x, x2(o)], [o.y, y2(o)], [o.z, z2(o)]] for o in things], gap);
}

// They overlap, seen from above.
fun above_each_other(a, b) { return all(overlap_x(a, b), overlap_y(a, b)); }

// a stands on b, and nothing of it sticks out.
fun on_top(a, b) { return all(a.z == z2(b), inside(a, b)); }

// a stands on b, at least with a part.
fun touches_top(a, b) { return all(a.z == z2(b), above_each_other(a, b)); }

// o stands on the floor, or on at least `least` of the others.
fun supported(o, others, floor = 0, least = 1) {
  return any(o.z == floor, count([touches_top(o, other) for other in others]) >= least);
}

fun show_box(o, color = nil) {
  if color == nil then place(o.kind, at: [o.x, o.y, o.z], size: [o.w, o.d, o.h], turn: o.turn);
  else place(o.kind, at: [o.x, o.y, o.z], size: [o.w, o.d, o.h], turn: o.turn, color: color);
}
