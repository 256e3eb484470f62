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

// A cell is six metres wide. Each kind lies on those below it.
unit(6);
heights = [0, 0.06, 0.16, 0.24];
paints = ["#3f86b8", "#e6d3a1", "#86b04d", "#4f8a3c"];
output {
  place("sea", at: [0, 0, -0.1], size: [w, h, 0.1], material: "water");
  for x, y, cell in each_cell(level) {
    for kind in 1..cell {
      is_in = fun(a, b) { return if a in 0..w - 1 and b in 0..h - 1 then level[b][a] >= kind else false; };
      place(kinds[kind], at: [0, 0, heights[kind - 1]], outline: rounded_cell(x, y, is_in), extrude: heights[kind] - heights[kind - 1],
            color: paints[kind]);
    }
    at, number = heights[cell], 3 * x + 5 * y;
    for u, v in if cell == 3 then [[0.12, 0.12], [0.55, 0.2], [0.25, 0.55]] else []:
      place(if number % 2 == 0 then "fir_tree" else "tree", at: [x + u, y + v, at], scale: 0.75 + number % 3 * 0.12);
    if cell == 2 and number % 3 == 0 then place("bush", at: [x + 0.35, y + 0.4, at], scale: 1.2);
    if cell == 1 and number % 5 == 0 then place("crate", at: [x + 0.4, y + 0.45, at], angle: 20 * number);
  }
}
