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
place("street", at: [-0.5, -0.5, -0.05], size: [1.5 * w + 0.5, 1.5 * d + 0.5, 0.05], color: "gray");
output {
  for y, row in enumerate(lots) {
    for x, use in enumerate(row) {
      place(use.name, at: [1.5 * x, 1.5 * y], size: [1, 1, max(0.1, height[y][x] * 0.4)], color: use.color);
    }
  }
  return skyline;
}
