// Shows: a map of tiles: water around land of one piece, beaches between them, and forests inside.
import "std/graph.sol";
import "std/grid.sol";

param w = 8;
param h = 7;
param land = 22;

kinds = ["water", "beach", "grass", "forest"];
level = make_grid(w, h, fun() { return range(0, 3); });           // the number of the kind
dry = [cell > 0 for cell in flat(level)];
graph = grid_graph(w, h);

assert(connected(graph, dry, most: 14), "one island");
assert(count(dry) == land);
for i, cell in enumerate(flat(level)) {
  around = flat(level)[graph[i]];
  assert(length(around) == 4 or cell == 0, "water at the edge");
  assert(all([abs(cell - other) <= 1 for other in around]), "kinds change step by step");
}
assert(count(flat(level), 3) >= 2, "a forest");

heights = [0.05, 0.15, 0.25, 0.3];
colors = ["blue", "beige", "lime", "green"];
output {
  for y, row in enumerate(level) {
    for x, cell in enumerate(row) {
      place(kinds[cell], at: [x, y], size: [1, 1, heights[cell]], color: colors[cell]);
      if cell == 3 then place("tree", at: [x + 0.2, y + 0.2, 0.3], size: [0.6, 0.6]);
    }
  }
}
