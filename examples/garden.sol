// Shows: a vegetable garden: good neighbours side by side, a path that reaches every bed.
import "std/graph.sol";
import "std/grid.sol";

param w = 6;
param h = 5;

plants = ["carrot", "onion", "bean", "tomato"];
enemies = [["onion", "bean"], ["carrot", "tomato"]];
garden = make_grid(w, h, fun() { return choose(plants + ["path"]); });
cells = flat(garden);
graph = grid_graph(w, h);

paths = [cell == "path" for cell in cells];
assert(connected(graph, paths) and cells[w / 2] == "path", "the path goes on, from the gate");
for i, cell in enumerate(cells) {
  around = cells[graph[i]];
  assert(cell == "path" or "path" in around, "every bed is reached");
  for a, b in enemies: assert(cell != a or b not in around, "bad neighbours");
}
assert(count(paths) <= w * h / 2 - 2, "more beds than paths");
for plant in plants: assert(count(cells, plant) >= 4, "some of each");

fun join(texts) { return if length(texts) == 1 then texts[0] else texts[0] + ", " + join(cdr(texts)); }
output {
  for i, cell in enumerate(cells) {
    x, y = i % w, i / w;
    if cell == "path" then place("path", at: [x, y], size: [1, 1, 0.05], material: "stone");
    else {
      place("raised_bed", at: [x, y], size: [1, 1]);
      for u, v in [[0, 0], [1, 0], [0, 1], [1, 1]] {
        place(cell, at: [x + 0.1 + 0.42 * u, y + 0.1 + 0.42 * v, 0.17], size: [0.38, 0.38]);
      }
    }
  }
  print(join([str(count(cells, plant), " ", plant) for plant in plants]));
}
