// Shows: things put together from parts that fit each other: spaceships of bricks.
//
// A deck of plates; on it a cockpit, a body of bricks, wings that lie on the deck with one row of studs, engines at the
// back. Everything is held by studs, both sides are alike, and the ship balances on its wings.
// Try: -n 16, --set longest=20, --set wings=2
import "std/layout.sol";

param longest = 16;   // studs
param wings = 0;      // pairs of them; 0: one or two

unit(0.0016);         // a stud's square is 5 wide, a plate 2 high, a brick 6 high
plate, brick = 2, 6;

colors = choose([["#f2f2ee", "#c8392b", "#3d4653"], ["#9aa3ab", "#2d5fa8", "#f0c33c"], ["#e9e4d4", "#3f7d4e", "#e08a2d"],
                 ["#4a505c", "#e3b52f", "#b23a2e"]]);
main_color, second, third = colors[0], colors[1], colors[2];

// x and y in studs, z in units; y runs from the nose to the engines, x from the middle to the right.
fun part(kind, x, y, z, color, turn = 0) { place(kind, at: [5 * x, 5 * y, z], turn: turn, color: color); }

// ---- the deck, four studs wide: pieces of four or eight

pieces = [choose([4, 8]) for i in 1..range(2, 3)];
length_of_deck = sum(pieces);
assert(length_of_deck >= 12 and length_of_deck <= longest, "long enough to fly");

// ---- on its middle: the cockpit, the body, engines

first = range(0, 2);                      // where the cockpit begins
body_y = first + 4;
bricks = [choose([2, 4, 6]) for i in 1..range(1, 3)];
body_end = body_y + sum(bricks);
assert(body_end + 1 == length_of_deck, "the engine stands behind the body, on the deck's last row of studs");
two_floors = flip();                      // a second layer of bricks, over a joint of the first
floor_y = range(4, longest);
floor_length = choose([2, 4, 6]);
assert(not two_floors or (floor_y >= body_y and floor_y + floor_length <= body_end), "it stands on the body");
ends, y = [], body_y;
for n in bricks {
  y += n;
  ends = ends + [y];
}
joined_by_it = any([floor_y < end and end < floor_y + floor_length for end in ends]);
assert(not two_floors or joined_by_it or length(bricks) == 1, "it holds bricks together");

// ---- wings, four studs wide and deep, which overlap the deck by one stud; the body is between them

pairs_of_wings = cond(wings == 0, range(1, 2), wings);
wing_y = [range(0, longest) for i in 1..pairs_of_wings];
for y in wing_y: assert(y >= first + 3 and y + 4 <= length_of_deck, "wings lie on the deck, behind the nose");
for i in 0..length(wing_y) - 2: assert(wing_y[i] + 4 <= wing_y[i + 1], "one pair behind the other");
middle = sum(wing_y) / length(wing_y) + 2;
assert(2 * middle >= length_of_deck, "the wings are behind the middle");
assert(3 * middle <= 2 * length_of_deck + 6, "and not at the end");
tips = choose(["round_brick_1x1", "cone_1x1", "tail_fin", "nothing"]);   // on the ends of the wings
mast = choose(["dish_2x2", "antenna", "nothing"]);
big_fin = flip();
assert(tips == "tail_fin" or big_fin, "a ship needs a fin");
assert(not (two_floors and big_fin) or floor_y + floor_length <= body_end - 2, "the fin stands behind the second layer");

// ---- what it looks like

fun show_deck() {
  y = 0;
  for n in pieces {
    part(cond(n == 8, "plate_8x4", "plate_4x4"), 0 - 2, y, 0, third, cond(n == 8, 1, 0));
    y += n;
  }
  part("slope_inverted_2x2", 0 - 1, 0, 0 - brick, third);
  part("brick_2x2", 0 - 1, 2, 0 - brick, third);
}

fun show_body() {
  part("cockpit_2x4", 0 - 1, first, plate, main_color);
  y = body_y;
  for i in 0..length(bricks) - 1 {
    n = bricks[i];
    part(cond(n == 2, "brick_2x2", cond(n == 4, "brick_4x2", "brick_6x2")), 0 - 1, y, plate, cond(i % 2 == 0, main_color, second), 1);
    y += n;
  }
  part("engine_2x2", 0 - 1, body_end, plate, "#8d959d");
  top = plate + brick;
  if two_floors {
    part(cond(floor_length == 2, "brick_2x2", cond(floor_length == 4, "brick_4x2", "brick_6x2")), 0 - 1, floor_y, top, main_color, 1);
    if mast != "nothing" then part(mast, cond(mast == "dish_2x2", 0 - 1, 0), floor_y, top + brick, "#aab2b8");
  }
  if big_fin then part("tail_fin", 0 - 0.5, body_end - 2, top, second);
}

fun show_wings(y) {
  for side in [0 - 1, 1] {
    part(cond(side < 0, "wing_left", "wing_right"), cond(side < 0, 0 - 5, 1), y, plate, second);
    tip = cond(side < 0, 0 - 5, 4);
    if tips != "nothing" then part(tips, tip, y + 2, 2 * plate, main_color);
    part("plate_1x1", cond(side < 0, 0 - 2, 1), y + 1, 2 * plate, main_color);
    part("round_brick_1x1", cond(side < 0, 0 - 4, 3), y + 1, plate - brick, third);
  }
}

show_deck();
show_body();
for y in wing_y: show_wings(y);
return [length_of_deck, length(wing_y), tips, mast];
