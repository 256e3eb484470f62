// Shows: a city of blocks: a skyline that rises and falls, parks near homes, no home in the shade of a tower.
import "std/grid.sol";

param w = 5;
param d = 4;
param tallest = 12;

record Use(name, least, most, color);
uses = [Use("home", 2, 5, "orange"), Use("office", 4, 8, "blue"), Use("shop", 1, 2, "yellow"),
        Use("tower", 9, tallest, "silver"), Use("park", 0, 0, "green")];
lots = make_grid(w, d, fun() { return choose(uses); });
height = make_grid(w, d, fun() { return range(0, tallest); });
fun names(some) { return [use.name for use in some]; }

for y in 0..d - 1 {
  for x in 0..w - 1 {
    name, around = lots[y][x].name, names(beside(lots, x, y));
    assert(height[y][x] >= lots[y][x].least and height[y][x] <= lots[y][x].most, "as high as its use");
    assert(name != "home" or "park" in around or "shop" in around, "a park or a shop near each home");
    assert(name != "tower" or "tower" not in around and "home" not in around, "no home in a tower's shade");
    assert(name != "park" or "park" not in around, "parks spread");
  }
}
all_names = names(flat(lots));
assert(count(all_names, "park") == 3 and count(all_names, "tower") >= 2 and count(all_names, "home") >= w * d / 3);

skyline = [max(column) for column in columns(height)];   // as it is seen from the front
peak = range(1, w - 2);
for x in 0..w - 2 {
  assert(cond(x < peak, skyline[x] <= skyline[x + 1], skyline[x] >= skyline[x + 1]), "it rises and falls");
}
assert(max(skyline) == tallest);

unit(10);
place("asphalt", at: [-0.6, -0.6, -0.01], size: [1.5 * w + 0.7, 1.5 * d + 0.7, 0.01], material: "asphalt");
paints = ["red", "silver", "blue", "white", "black", "#2f6f5e"];

// What stands on a lot of ten metres.
fun show_lot(use, x, y, floors) {
  place("pavement", at: [1.5 * x - 0.06, 1.5 * y - 0.06], size: [1.12, 1.12, 0.015], material: "concrete");
  if use.name == "park" then {
    place("lawn", at: [1.5 * x, 1.5 * y], size: [1, 1, 0.02]);
    if (x + y) % 2 == 0 then place("fountain", at: [1.5 * x + 0.29, 1.5 * y + 0.29, 0.018]);
    for u, v in [[0.05, 0.7], [0.68, 0.66], [0.7, 0.1]] { place(if (x + y) % 2 == 0 then "tree" else "tall_tree", at: [1.5 * x + u, 1.5 * y + v, 0.018], size: [0.28, 0.28]); }
    place("bench", at: [1.5 * x + 0.15, 1.5 * y + 0.12, 0.018]);
    return;
  }
  at = [1.5 * x + 0.02, 1.5 * y + 0.02, 0.015];
  high = floors * 0.4;
  if use.name == "home" and floors <= 3 then {
    place("lawn", at: [1.5 * x, 1.5 * y], size: [1, 1, 0.017]);
    place(if floors == 2 then "cottage" else "house", at: [1.5 * x + 0.03, 1.5 * y + 0.06, 0.015], size: [0.94, 0.85], tint: floors == 3, color: if floors == 3 then "#ffe9d2" else nil);
  }
  else if use.name == "home" then for u in [0.02, 0.5]: place("town_house", at: [1.5 * x + u, 1.5 * y + 0.05, 0.015], size: [0.48, 0.9, high * 0.75]);
  else if use.name == "shop" then place("corner_shop", at: [1.5 * x + 0.1, 1.5 * y + 0.0, 0.015], size: [0.8, 1, 0.36 + 0.24 * floors]);
  else if use.name == "office" then place("apartments", at: at, size: [0.96, 0.86, high]);
  else place("office_tower", at: [1.5 * x + 0.08, 1.5 * y + 0.08, 0.015], size: [0.84, 0.84, high]);
}
output {
  for y, row in enumerate(lots) {
    for x, use in enumerate(row) {
      show_lot(use, x, y, height[y][x]);
      number = y * w + x;
      if number % 2 == 0 then place("car", at: [1.5 * x + 1.12, 1.5 * y + 0.3], color: paints[number % 6]);
      if number % 3 == 1 then place(if number % 4 == 0 then "bus" else "small_car", at: [1.5 * x + 0.2, 1.5 * y - 0.36], turn: 1, color: paints[(number + 2) % 6]);
      place("street_lamp", at: [1.5 * x + 1.0, 1.5 * y - 0.05, 0.015], turn: 1);
    }
  }
  return skyline;
}
