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

// ---- what it looks like: a cell is six metres wide; each corner of a cell that nothing of its height goes on from is cut off

unit(6);
heights = [0, 0.06, 0.16, 0.24];
paints = ["#3f86b8", "#e6d3a1", "#86b04d", "#4f8a3c"];
fun at_least(x, y, kind) { return if x < 0 or y < 0 or x >= w or y >= h then false else level[y][x] >= kind; }

// The outline of a cell: a corner between two sides without a neighbour is rounded.
fun corner(x, y, dx, dy, kind) {
  u, v = x + (dx + 1) / 2, y + (dy + 1) / 2;
  if at_least(x + dx, y, kind) or at_least(x, y + dy, kind) then return [[u, v]];
  along = [[u, v - 0.45 * dy], [u - 0.13 * dx, v - 0.13 * dy], [u - 0.45 * dx, v]];
  return if dx == dy then along else reverse(along);
}
fun shore(x, y, kind) {
  return corner(x, y, 1, 1, kind) + corner(x, y, -1, 1, kind) + corner(x, y, -1, -1, kind) + corner(x, y, 1, -1, kind);
}
output {
  place("sea", at: [0, 0, -0.1], size: [w, h, 0.1], material: "water");
  for y, row in enumerate(level) {
    for x, cell in enumerate(row) {
      // Each kind lies on those below it.
      for kind in 1..cell {
        place(kinds[kind], at: [0, 0, heights[kind - 1]], outline: shore(x, y, kind), extrude: heights[kind] - heights[kind - 1],
              color: paints[kind]);
      }
      at = heights[cell];
      number = 3 * x + 5 * y;
      if cell == 3 then {
        for u, v in [[0.12, 0.12], [0.55, 0.2], [0.25, 0.55]] { place(if number % 2 == 0 then "fir_tree" else "tree", at: [x + u, y + v, at], scale: 0.75 + number % 3 * 0.12); }
      }
      if cell == 2 and number % 3 == 0 then place("bush", at: [x + 0.35, y + 0.4, at], scale: 1.2);
      if cell == 1 and number % 5 == 0 then place("crate", at: [x + 0.4, y + 0.45, at], angle: 20 * number);
    }
  }
}
