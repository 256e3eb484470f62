// Shows: a parking lot on a grid: lanes of one net, stalls on lanes, those for the disabled near the gate, trees.
import "std/graph.sol";
import "std/grid.sol";

param w = 7;
param h = 6;
param stalls = 18;
param disabled = 2;
param trees = 3;

lot = make_grid(w, h, fun() { return choose(["lane", "stall", "disabled", "tree"]); });
gate = range(0, w - 1);
lanes = [cell == "lane" for cell in flat(lot)];
far = distances(grid_graph(w, h), lanes, [i == gate for i in 0..w * h - 1], most: w + h);   // from the gate

assert(count(flat(lot), "stall") >= stalls, "enough stalls");
assert(count(flat(lot), "disabled") == disabled and count(flat(lot), "tree") == trees);
for y in 0..h - 1 {
  for x in 0..w - 1 {
    near = min([far[b * w + a] for b in max(y - 1, 0)..min(y + 1, h - 1) for a in max(x - 1, 0)..min(x + 1, w - 1)
                if (a == x) != (b == y)]);
    assert(lot[y][x] != "lane" or far[y * w + x] <= w + h, "lanes are one net");
    assert(lot[y][x] not in ["stall", "disabled"] or near <= w + h, "a stall on a lane");
    assert(lot[y][x] != "disabled" or near <= 2, "near the gate");
  }
}

unit(2.5);
place("asphalt", at: [0, 0, -0.1], size: [w, h, 0.1], color: "gray");
output {
  for y, row in enumerate(lot) {
    for x, cell in enumerate(row) {
      if cell == "tree" then place("tree", at: [x, y], size: [1, 1]);
      if cell in ["stall", "disabled"] then
        place(cell, at: [x + 0.05, y + 0.05], size: [0.9, 0.9, 0.02], color: if cell == "stall" then "white" else "blue");
    }
  }
  place("gate", at: [gate, -0.3], size: [1, 0.2, 0.4], color: "red");
  print(str(count(flat(lot), "stall"), " stalls"));
}
