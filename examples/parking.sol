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
far = in_rows(distances(grid_graph(w, h), [cell == "lane" for cell in flat(lot)], [i == gate for i in 0..w * h - 1], most: w + h), w);

assert(count(flat(lot), "stall") >= stalls, "enough stalls");
assert(count(flat(lot), "disabled") == disabled and count(flat(lot), "tree") == trees);
for x, y, cell in each_cell(lot) {
  near = min(beside(far, x, y));
  assert(cell != "lane" or far[y][x] <= w + h, "lanes are one net");
  assert(cell not in ["stall", "disabled"] or near <= w + h, "a stall on a lane");
  assert(cell != "disabled" or near <= 2, "near the gate");
}

unit(5);
paints = ["red", "silver", "blue", "white", "black", "#2f6f5e", "orange", "#7a8fa6", "maroon"];
output {
  place("asphalt", at: [-0.4, -0.4, -0.02], size: [w + 0.8, h + 0.8, 0.02], material: "asphalt");
  for x, y, cell in each_cell(lot) {
    if cell == "tree" then {
      place("lawn", at: [x + 0.05, y + 0.05], size: [0.9, 0.9, 0.04]);
      place("tree", at: [x + 0.2, y + 0.2, 0.03], size: [0.6, 0.6]);
    }
    for side in if cell in ["stall", "disabled"] then [0, 1] else [] {
      turn = turn_to(lot, x, y, "lane");
      across = turn % 2 == 1;
      place("parking_space", at: if across then [x, y + 0.5 * side] else [x + 0.5 * side, y], size: [0.5, 1, 0.01], turn: turn,
            color: if cell == "stall" then nil else "blue");
      number = (y * w + x) * 7 + side * 3;
      if number % 4 != 0 then
        place(if number % 2 == 0 then "car" else "small_car", turn: turn, color: paints[number % length(paints)],
              at: if across then [x + 0.1, y + 0.5 * side + 0.06, 0.01] else [x + 0.06 + 0.5 * side, y + 0.1, 0.01]);
    }
  }
  for x in [gate, gate + 0.96]: place("post", at: [x, -0.28], size: [0.04, 0.04, 0.22], color: "silver");
  for k in 0..5: place("barrier", at: [gate + 0.04 + 0.15 * k, -0.27, 0.17], size: [0.15, 0.02, 0.03], color: if k % 2 == 0 then "red" else "white");
  print(str(count(flat(lot), "stall"), " stalls"));
}
