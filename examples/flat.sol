// Shows: a plan whose rooms and furniture depend on each other. Every room has a door, and everything can be reached.
//
// A hall runs through the flat, with rooms on both sides in some order. In each room there is a way: a free rectangle that
// one can walk from the door to the front of everything that is used. Try: --set hall_width=12, -n 20
import "std/layout.sol";

param hall_width = 14;

unit(0.1);
wall = 1;
most = 130;

record Room(name, area, door, window, way, things);

// ---- the plan: two rooms above the hall, three below it

width = range(90, 120);
above, below = range(34, 46), range(30, 42);     // how deep the rooms are
hall_y = below + wall;
above_y = hall_y + hall_width + wall;

fun made_room(name, x, y, w, d, is_above) {
  area = Rect(x, y, w, d);
  door = Thing("door", 9, 1, cond(is_above, 2, 0), range(0, most), cond(is_above, y, y + d - 1));
  window = Thing("window", 12, 1, cond(is_above, 0, 2), range(0, most), cond(is_above, y + d - 1, y));
  way = Rect(range(0, most), range(0, most), range(7, most), range(7, most));
  assert(inside(door, area, 0) and door.x >= x + 1 and door.x + 9 < x + w, "the door is in the wall to the hall");
  assert(inside(window, area, 0) and window.x >= x + 4 and window.x + 16 <= x + w, "the window is in the outer wall");
  assert(inside(way, area));
  assert(meet(way, front(door, 7), 7), "the way begins at the door");
  return Room(name, area, door, window, way, []);
}

// They share a square of that side: one can step from one into the other.
fun meet(a, b, least) { return overlap_x(a, b, least) and overlap_y(a, b, least); }

living_first = flip();
living_w, kitchen_w = range(45, 75), range(38, 60);
assert(living_w + wall + kitchen_w == width, "the rooms above the hall fill its length");
living = made_room("living room", cond(living_first, 0, kitchen_w + wall), above_y, living_w, above, true);
kitchen = made_room("kitchen", cond(living_first, living_w + wall, 0), above_y, kitchen_w, above, true);

bed_w, study_w, bath_w = range(34, 50), range(28, 44), range(20, 30);
assert(bed_w + study_w + bath_w + 2 * wall == width, "and those below");
order = choose([[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]]);   // places of bed, study, bath
widths = [bed_w, study_w, bath_w];
fun place_of(i) { return sum([cond(order[j] < order[i], widths[j] + wall, 0) for j in 0..2]); }
bedroom = made_room("bedroom", place_of(0), 0, bed_w, below, false);
study = made_room("study", place_of(1), 0, study_w, below, false);
bathroom = made_room("bathroom", place_of(2), 0, bath_w, below, false);

// ---- furniture

// A thing with its back to a wall of the room. Whoever uses it comes to its front.
fun along_wall(kind, w, d, room) {
  o = anywhere(kind, w, d, most, most);
  assert(flush(o, room.area), "its back is to a wall");
  assert(meet(room.way, front(o, 7), 5), "one can get to it");
  return o;
}

fun furnish(room, things, tall) {
  assert(all_apart(things + [front(room.door, 8)]));
  assert(lists_apart(things, [room.way]), "the way is free");
  for o in things: assert(inside(o, room.area));
  for o in tall: assert(apart(o, room.window), "nothing tall stands before the window");
}

sofa = along_wall("sofa", 20, 9, living);
tv = along_wall("tv", 16, 5, living);
assert(tv.turn == (sofa.turn + 2) % 4, "the sofa looks at the television");
assert(cond(turned(sofa), y1(sofa) <= y1(tv) and y2(tv) <= y2(sofa), x1(sofa) <= x1(tv) and x2(tv) <= x2(sofa)));
coffee = in_frame(sofa, "coffee_table", 4, 0 - 10, 11, 6);
books = along_wall("bookcase", 9, 3, living);
plant = anywhere("plant", 6, 6, most, most);
assert(flush(plant, living.area));
furnish(living, [sofa, tv, coffee, books, plant], [books]);

units = along_wall("", 32, 7, kitchen);          // a row of kitchen units
dining = anywhere("", 14, 18, most, most);       // a table with two chairs at each of its long sides
assert(inside(dining, kitchen.area, 2) and meet(kitchen.way, front(dining, 7), 7), "one can get to the table");
furnish(kitchen, [units, dining], []);
assert(units.turn != kitchen.window.turn, "the window is not behind the cupboards");

bed = along_wall("bed", 16, 21, bedroom);
wardrobe = along_wall("wardrobe", 15, 6, bedroom);
night = in_frame(bed, "nightstand", 17, 16, 5, 5);
beside = in_frame(bed, "", 16, 0, 6, 16);         // where one gets up
assert(inside(beside, bedroom.area));
furnish(bedroom, [bed, wardrobe, night], [wardrobe]);
assert(lists_apart([beside], [wardrobe]));

desk = along_wall("computer_desk", 14, 7, study);
study_books = [along_wall("bookcase", 9, 3, study) for i in 1..2];
guest = along_wall("armchair", 9, 9, study);
furnish(study, [desk, guest] + study_books, study_books);
assert(lists_apart([front(desk, 9)], [guest] + study_books), "90 cm to sit at the desk");

basin = along_wall("washbasin", 8, 5, bathroom);
toilet = along_wall("toilet", 4, 7, bathroom);
shower = along_wall("shower", 9, 9, bathroom);
washer = along_wall("washing_machine", 6, 6, bathroom);
furnish(bathroom, [basin, toilet, shower, washer], [basin, shower]);

front_door = Thing("door", 9, 1, choose([1, 3]), range(0, most), hall_y + 2);
assert(flush(front_door, Rect(0, hall_y, width, hall_width)), "one enters at an end of the hall");

// ---- what it looks like

fun show_wall_piece(x, y, w, d) { if w > d then place("wall", at: [x, y], size: [w, d]) else place("wall", at: [x, y], size: [d, w], turn: 1); }

rooms = [living, kitchen, bedroom, study, bathroom];
height = above_y + above;
place("floor", at: [0, hall_y - wall], size: [width, hall_width + 2 * wall], material: "oak", name: "hall");
for room in rooms {
  a = room.area;
  wet = room.name == "bathroom" or room.name == "kitchen";
  place("floor", at: [a.x, a.y], size: [a.w, a.d], material: cond(wet, "tiles", "birch"), name: room.name);
  show_in_wall(room.door, a, wall);
  window = room.window;
  place("window", at: [window.x, cond(window.turn == 0, height - 0.1, 0 - wall - 0.2), 8.5], size: [12, 1.3], turn: window.turn);
}
show_in_wall(front_door, Rect(0, hall_y, width, hall_width), wall);

show_wall_piece(0 - wall, 0 - wall, width + 2 * wall, wall);
show_wall_piece(0 - wall, height, width + 2 * wall, wall);
show_wall_piece(0 - wall, 0, wall, height);
show_wall_piece(width, 0, wall, height);
show_wall_piece(0, below, width, wall);
show_wall_piece(0, above_y - wall, width, wall);
show_wall_piece(cond(living_first, living_w, kitchen_w), above_y, wall, above);
for room in [bedroom, study, bathroom] {
  if room.area.x > 0 then show_wall_piece(room.area.x - wall, 0, wall, below);
}

rug = in_frame(sofa, "rug", 0, 0 - 13, 20, 12);
place("rug", at: [rug.x, rug.y, 0.2], size: [20, 12], turn: rug.turn);   // on the floor, which is 2 cm thick
show_all([sofa, coffee, tv, books, plant]);
show_all([bed, wardrobe, night]);
show_all([desk, guest] + study_books);
show(in_frame(desk, "office_chair", 2, 0 - 4, 6, 6, 2));
show_all([basin, toilet, shower, washer]);
show_all([in_frame(units, kind, u, 0, w, 6.2) for kind, u, w in [["fridge", 0, 6], ["counter", 6, 6], ["stove", 12, 6], ["counter", 18, 6], ["sink", 24, 8]]]);
show(in_frame(dining, "table", 0, 5, 14, 8));
for u in [2, 8] {
  show(in_frame(dining, "chair", u, 2, 4, 5, 2));
  show(in_frame(dining, "chair", u, 11, 4, 5));
}
return [[room.name, room.area.w, room.area.d] for room in rooms];
