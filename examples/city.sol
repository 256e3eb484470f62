// Shows: a city of blocks: a skyline that rises and falls, parks near homes, no home in the shade of a tower.
import "std/grid.sol";

param w = 5;
param d = 4;
param tallest = 12;

// How many floors there are, and the building: where on its lot, how large, and how much higher by each floor.
record Use(name, least, most, model, x, y, size, rise);
uses = [Use("home", 2, 3, "house", 0.03, 0.06, [0.94, 0.85], 0.2), Use("home", 4, 5, "town_house", 0.02, 0.05, [0.48, 0.9], 0.3),
        Use("shop", 1, 2, "corner_shop", 0.1, 0, [0.8, 1], 0.42), Use("office", 4, 8, "apartments", 0.02, 0.02, [0.96, 0.86], 0.4),
        Use("tower", 9, tallest, "office_tower", 0.08, 0.08, [0.84, 0.84], 0.4), Use("park", 0, 0, nil, 0, 0, [1, 1], 0)];
lots = make_grid(w, d, fun() { return choose(uses); });
height = make_grid(w, d, fun() { return range(0, tallest); });

for x, y, use in each_cell(lots) {
  around = [other.name for other in beside(lots, x, y)];
  assert(height[y][x] >= use.least and height[y][x] <= use.most, "as high as its use");
  assert(use.name != "home" or "park" in around or "shop" in around, "a park or a shop near each home");
  assert(use.name != "tower" or "tower" not in around and "home" not in around, "no home in a tower's shade");
  assert(use.name != "park" or "park" not in around, "parks spread");
}
names = [use.name for use in flat(lots)];
assert(count(names, "park") == 3 and count(names, "tower") >= 2 and count(names, "home") >= w * d / 3);

skyline = [max(column) for column in columns(height)];   // as it is seen from the front
peak = range(1, w - 2);
for x in 0..w - 2: assert(cond(x < peak, skyline[x] <= skyline[x + 1], skyline[x] >= skyline[x + 1]), "it rises and falls");
assert(max(skyline) == tallest);

// A lot is ten metres wide, and so are a street and its pavements beside it.
unit(10);
paints = ["red", "silver", "blue", "white", "black", "#2f6f5e"];
fun put(model, x, y, u, v, z, size = nil, turn = 0, color = nil) { place(model, at: [1.5 * x + u, 1.5 * y + v, z], size: size, turn: turn, color: color); }
output {
  place("asphalt", at: [-0.6, -0.6, -0.01], size: [1.5 * w + 0.7, 1.5 * d + 0.7, 0.01], material: "asphalt");
  for x, y, use in each_cell(lots) {
    number = y * w + x;
    place("pavement", at: [1.5 * x - 0.06, 1.5 * y - 0.06], size: [1.12, 1.12, 0.015], material: "concrete");
    if use.name in ["park", "home"] then put("lawn", x, y, 0, 0, 0, [1, 1, 0.02]);
    if use.name == "park" then {
      tree = if number % 2 == 0 then "tree" else "tall_tree";
      for u, v in [[0.05, 0.7], [0.68, 0.66], [0.7, 0.1]]: put(tree, x, y, u, v, 0.018, [0.28, 0.28]);
      for model, u, v in [["fountain", 0.29, 0.29], ["bench", 0.15, 0.12]]: put(model, x, y, u, v, 0.018);
    }
    for u in if use.name == "park" then [] else if use.model == "town_house" then [0, 0.48] else [0]:
      put(use.model, x, y, use.x + u, use.y, 0.015, use.size + [use.rise * height[y][x]]);
    if number % 2 == 0 then put("car", x, y, 1.12, 0.3, 0, color: paints[number % 6]);
    if number % 3 == 1 then put(if number % 4 == 0 then "bus" else "small_car", x, y, 0.2, -0.36, 0, nil, 1, paints[(number + 2) % 6]);
    put("street_lamp", x, y, 1, -0.05, 0.015, nil, 1);
  }
  return skyline;
}
