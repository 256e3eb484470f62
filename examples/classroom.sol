// Shows: a room planned for people. How many rows and columns of desks there are follows from the pupils, and the room
// fits them.
//
// All pupils look at the blackboard and can walk to their places and out of the door. The teacher sits beside the board.
// Try: --set pupils=12, --set pupils=30, --set aisle=12
import "std/layout.sol";

param pupils = 24;
param aisle = 7;     // between columns, and along the walls: 70 cm

unit(0.1);
most = 110;          // no room is wider or deeper than 11 m
board_width = 30;
deep = 13;           // from row to row: a desk, a chair, and room to sit down

// ---- desks in rows and columns

kind = choose(["school_desk", "school_desk_double"]);
desk_width = cond(kind == "school_desk", 7, 13);
seats = cond(kind == "school_desk", 1, 2);     // at each desk
columns, rows = range(2, 6), range(2, 6);
assert(columns * rows * seats >= pupils, "everybody has a place");
assert((columns * rows - columns) * seats < pupils, "no row stays empty");

wide = columns * desk_width + (columns - 1) * aisle;
long = rows * deep;
room = Rect(0, 0, range(50, most), range(60, most));
assert(room.w <= 2 * room.d and room.d <= 2 * room.w, "it is not a corridor");

desks = Rect(range(0, most), range(0, most), wide, long);
assert(desks.x >= aisle + 3 and desks.x + wide + aisle + 3 <= room.w, "a way along the walls");
assert(desks.y >= 8, "a way behind the last row");
front_row = desks.y + long;
assert(room.d - front_row >= 24 and room.d - front_row <= 30, "the first row is neither too near to the board nor too far");
assert(desks.y <= 14, "no space is wasted behind");
assert(room.w - wide <= 2 * aisle + 24, "nor beside");
middle = desks.x + wide / 2;
assert(middle >= room.w / 2 - 3 and middle <= room.w / 2 + 3, "the desks stand before the board");
assert(long + 24 >= wide / 2, "nobody looks at the board too much from the side");

// ---- what stands at the front: the board on the wall in the middle, all else beside it

board = Rect(room.w / 2 - board_width / 2, room.d - 1, board_width, 1);
teacher = Thing("teacher_desk", 16, 8, 2, range(2, most), room.d - 18);   // who sits there looks at the pupils
plant = Thing("plant", 6, 6, 0, range(1, most), room.d - 7);
shelf = Thing("bookcase", 9, 3, 0, range(1, most), room.d - 4);
for o in [teacher, plant, shelf]: assert(inside(o, room, 1));
at_wall = [plant, shelf];
for o in at_wall: assert(apart(o, board, 1), "nothing stands before the board");
assert(apart(plant, shelf, 2));
seat = Thing("office_chair", 6, 6, 0, teacher.x + 5, teacher.y + 8);
for o in at_wall: assert(apart(o, seat), "there is room behind the teacher's desk");
assert(apart(front(shelf, 10), teacher), "one can get at the shelf");
assert(teacher.x + 16 <= board.x + 6 or teacher.x >= board.x + board_width - 6, "the teacher does not hide the board");

// ---- the door is in the right or the left wall, where nobody sits in its way; windows are in the other

door_right = flip();
door = Thing("door", 9, 1, cond(door_right, 3, 1), cond(door_right, room.w - 1, 0), range(2, most));
assert(flush(door, room));
assert(apart(front(door, 10), teacher) and apart(front(door, 10), shelf) and apart(front(door, 10), plant));
assert(y1(door) >= front_row or y2(door) <= desks.y + deep, "the door opens to the front or the back");

// ---- what it looks like

show_room(room);
for i in 0..columns - 1 {
  for k in 0..rows - 1 {
    x = desks.x + i * (desk_width + aisle);
    y = desks.y + k * deep;
    place(kind, at: [x, y + 6], size: [desk_width, 5], color: "#e2c391");
    for s in 0..seats - 1 {
      place("school_chair", at: [x + (desk_width * (2 * s + 1)) / (2 * seats) - 2, y + 2 - (i * 3 + k * 7 + s) % 3], size: [4, 4.5], turn: 2);
    }
  }
}
show(teacher);
show(seat);
place("globe", at: [teacher.x + 11, teacher.y + 1, 7.45]);
place("blackboard", at: [board.x, room.d - 1.2, 8], size: [board_width, 1.4]);
show_all(at_wall);
show_in_wall(door, room);
for i in 0..2 {
  place("window", at: [cond(door_right, -1.3, room.w - 0.1), room.d * (2 * i + 1) / 6 - 6, 8], size: [12.4, 1.4], turn: cond(door_right, 1, 3));
}
return [kind, columns, rows];
