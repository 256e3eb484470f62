// Shows: a kitchen along two walls, in which what is used together stands together, and every door opens.
import "std/layout.sol";
import "std/rooms.sol";

param side = 8;    // of the room, in half metres

unit(0.5);
room = Rect(0, 0, side, side);
door = Opening("door", 2, 0, 2);

fun appliance(kind, w) { return Thing(kind, w, 1, choose([0, 1]), range(0, side - 1), range(0, side - 1)); }
fridge, sink, stove = appliance("fridge", 2), appliance("sink", 2), appliance("stove", 2);
boards = [appliance("worktop", 2) for i in 1..3];
table = Thing("table", 3, 2, range(0, 1), range(0, side), range(0, side));
line = [fridge, sink, stove] + boards;

for o in line: assert(flush(o, room), "along the back or the left wall");
for o in line: assert(cond(o.turn == 0, o.x != 1, y2(o) != side - 1), "doors in the corner open");
assert(inside(table, room) and all_apart(line + [table]));
for o in line: assert(usable(o, line + [table], 2), "one can stand before it");
assert(way_is_free(door, line + [table], 2), "one can come in");
assert(any([touching(sink, b) for b in boards]) and any([touching(stove, b) for b in boards]), "a worktop beside sink and stove");
assert(not touching(fridge, stove), "the fridge stays cold");
steps = abs(fridge.x - sink.x) + abs(fridge.y - sink.y) + abs(sink.x - stove.x) + abs(sink.y - stove.y);
prefer(steps <= 8);

// Hangs something on the wall above o, so high.
fun show_above(o, kind, w, d, height) {
  beside = (o.w - w) / 2;
  at = if o.turn == 0 then [o.x + beside, o.y + 1 - d, height] else [o.x, o.y + beside, height];
  place(kind, at: at, size: [w, d], turn: o.turn);
}

output {
  show_room(room);
  show_in_wall(Thing("door", 2, 1, 2, door.x, door.y), room);
  show(table);
  for u in [0.3, 1.7] {
    for chair in [in_frame(table, "chair", u, -0.6, 1, 1, 2), in_frame(table, "chair", u, 1.6, 1, 1)] {
      if inside(chair, room) then show(chair);
    }
  }
  for o in line {
    at = if o.turn == 0 then [o.x, o.y - 0.24] else [o.x, o.y];   // units are 62 cm deep
    place(if o.kind == "worktop" then "counter" else o.kind, at: at, size: [o.w, 1.24], turn: o.turn);
    if o.kind == "worktop" then show_above(o, "wall_cupboard", o.w, 0.74, 2.8);
    if o.kind == "stove" then show_above(o, "hood", 1.2, 1, 3.2);
  }
  print(str(steps, " steps from fridge to sink to stove"));
}
