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

unit(5);
place("asphalt", at: [-0.4, -0.4, -0.02], size: [w + 0.8, h + 0.8, 0.02], material: "asphalt");
// The side of a stall where its lane is.
fun way_out(x, y) {
  if y > 0 then { if lot[y - 1][x] == "lane" then return 0; }
  if x < w - 1 then { if lot[y][x + 1] == "lane" then return 1; }
  if y < h - 1 then { if lot[y + 1][x] == "lane" then return 2; }
  return 3;
}
vehicles = ["car", "small_car", "car", "small_car"];
paints = ["red", "silver", "blue", "white", "black", "#2f6f5e", "orange", "#7a8fa6", "maroon"];

output {
  for y, row in enumerate(lot) {
    for x, cell in enumerate(row) {
      number = y * w + x;
      if cell == "tree" then {
        place("lawn", at: [x + 0.05, y + 0.05], size: [0.9, 0.9, 0.04]);
        place("tree", at: [x + 0.2, y + 0.2, 0.03], size: [0.6, 0.6]);
      }
      if cell in ["stall", "disabled"] then {
        turn = way_out(x, y);
        across = turn == 1 or turn == 3;
        for side in [0, 1] {
          place("parking_space", at: if across then [x, y + 0.5 * side] else [x + 0.5 * side, y], size: [0.5, 1, 0.01], turn: turn,
                color: if cell == "stall" then nil else "blue");
          if (number * 5 + 3 * side) % 4 != 0 then
            place(vehicles[(number + side * 2) % 4], at: if across then [x + 0.1, y + 0.5 * side + 0.06] else [x + 0.06 + 0.5 * side, y + 0.1, 0.01], turn: turn,
                  color: paints[(number * 7 + side * 3) % length(paints)]);
        }
      }
    }
  }
  for x in [gate, gate + 0.96]: place("post", at: [x, -0.28], size: [0.04, 0.04, 0.22], color: "silver");
  for k in 0..5: place("barrier", at: [gate + 0.04 + 0.15 * k, -0.27, 0.17], size: [0.15, 0.02, 0.03], color: if k % 2 == 0 then "red" else "white");
  print(str(count(flat(lot), "stall"), " stalls"));
}
