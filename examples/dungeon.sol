// Shows: rooms that hang together by doors, and keys that lie before the doors they open.
import "std/graph.sol";
import "std/layout.sol";
import "std/rooms.sol";

param rooms = 6;
param locks = 2;
param side = 12;

fun make_room() { w, d = range(3, 6), range(3, 6); return Rect(range(0, side - 3), range(0, side - 3), w, d); }
site = Rect(0, 0, side, side);
dungeon = [make_room() for i in 1..rooms];
for room in dungeon: assert(inside(room, site));
assert(all_apart(dungeon), "rooms do not overlap");

// Room 0 is the entrance. Each other room is entered from an earlier one, so that all of them can be reached.
from = [0] + [range(0, i - 1) for i in 1..rooms - 1];
doors = [door_between(dungeon[from[i]], dungeon[i]) for i in 1..rooms - 1];   // doors[i - 1] leads to room i

// Before and behind each door, a step of the way is its own.
steps = [swing(d) for d in doors];
assert(all_apart(steps), "doors do not stand in each other's way");

locked = [range(1, rooms - 1) for k in 1..locks];        // lock k closes the door to that room
keys = [range(0, rooms - 1) for k in 1..locks];          // and its key lies there
aux order = [range(0, rooms - 1) for i in 1..rooms];     // in which the rooms are entered
assert(distinct(order) and distinct(locked) and distinct(keys));
for i in 1..rooms - 1: assert(order[from[i]] < order[i], "from an earlier room");
for k in 0..locks - 1: assert(order[keys[k]] < order[locked[k]], "the key comes before the door");
assert(locked[0] == rooms - 1 and keys[0] != 0, "the last room is locked");

fun show_gate(kind, gate, color) {
  place(kind, at: if turned(gate) then [gate.x - 0.2, gate.y] else [gate.x, gate.y - 0.2], size: [1, 0.4, 1.05], turn: gate.turn,
        color: color);
}

output {
  show_rooms(dungeon, 0.3, 0.95, "stone");   // so low that nobody has to cut them off
  for i, door in enumerate(doors) { if i + 1 not in locked then show_gate("dungeon_arch", door, nil); }
  for i, room in enumerate(dungeon) {
    for x in 0..room.w - 1 { for y in 0..room.d - 1: place("dungeon_floor", at: [room.x + x, room.y + y, 0.0]); }
    if i % 3 == 1 then place("barrel", at: [room.x + 0.3, room.y + room.d - 0.95]);
    if i % 3 == 2 then place("skeleton", at: [room.x + room.w - 1.1, room.y + 0.6], turn: i % 4);
    place("torch", at: [room.x + room.w / 2.0 - 0.05, room.y + room.d - 0.42, 0.4]);
  }
  last_room = dungeon[rooms - 1];
  place("chest", at: [last_room.x + last_room.w / 2.0 - 0.4, last_room.y + last_room.d / 2.0 - 0.3]);
  place("hero", at: [dungeon[0].x + dungeon[0].w / 2.0 - 0.3, dungeon[0].y + dungeon[0].d / 2.0 - 0.3], scale: 0.6);
  colors = ["red", "blue", "yellow"];
  for k in 0..locks - 1 {
    gate = doors[locked[k] - 1];
    show_gate("dungeon_door", gate, colors[k]);
    room = dungeon[keys[k]];
    place("key", at: [room.x + room.w / 2.0 + 0.3, room.y + room.d / 2.0], color: colors[k]);
    print(str("the ", colors[k], " key lies in room ", keys[k], " and opens the door to room ", locked[k]));
  }
}
