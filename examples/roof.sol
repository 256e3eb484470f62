// Shows: as many solar panels on a house's roof as fit, in blocks, away from chimney and windows.
import "std/layout.sol";

param width = 12;    // of the roof, in metres
param length = 8;    // along its slope
param blocks = 3;

chimney, window = Rect(3, 5, 1, 1), Rect(8, 2, 2, 2);
roof = Rect(0, 0, width, length);

// A block of panels, each 1 wide and 2 high.
fun block() { return Rect(range(0, width - 2), range(0, length - 2), range(2, 8), range(2, 6, 2)); }
panels = [block() for i in 1..blocks];
for b in panels: assert(inside(b, roof) and apart(b, chimney, 1) and apart(b, window, 1), "in the sun");
assert(all_apart(panels, 1), "a way to clean them");
number = sum([b.w * (b.d / 2) for b in panels]);
assert(number >= 18, "enough power");
prefer(number >= 22, 2);

// ---- the house: a slope of 30 degrees over walls of 3 metres

slope = 30;
rise, run = 0.5, 0.866;      // sine and cosine
eaves, deep = 3.0, length * run;
ridge = eaves + length * rise;

// What lies flat on the roof, seen from above its eaves: u to the right, v up the slope. A thing turns about the middle of its
// base, and `at` says where its corner was before.
fun on_roof(kind, u, v, w, d, high, above, color, material) {
  middle = [u + w / 2.0, (v + d / 2.0) * run - above * rise, eaves + (v + d / 2.0) * rise + above * run];
  place(kind, at: [middle[0] - w / 2.0, middle[1] - d / 2.0, middle[2]], size: [w, d, high], pitch: 0 - slope,
        color: color, material: material);
}
output {
  place("grass", at: [-4, -5, -0.02], size: [width + 8, deep * 2 + 10, 0.02], material: "grass");
  place("masonry", outline: [[0.3, 0.3], [width - 0.3, 0.3], [width - 0.3, 2 * deep - 0.3], [0.3, 2 * deep - 0.3]], extrude: eaves, color: "#efe6d6",
        material: "plaster");
  // The gables, and the other half of the roof.
  place("gable", at: [0.3, 0.3, eaves], size: [width - 0.6, 2 * deep - 0.6, ridge - eaves - 0.2], color: "#efe6d6");
  on_roof("roof", -0.3, -0.4, width + 0.6, length + 0.4, 0.14, 0, "#9c4a35", "tiles");
  place("roof", at: [-0.3, 2 * deep - deep / 2 - (length + 0.4) / 2.0 + 0.17, eaves + length * rise / 2 - 0.1], size: [width + 0.6, length + 0.4, 0.14], pitch: slope,
        color: "#9c4a35", material: "tiles");
  place("chimney", at: [chimney.x, chimney.y * run, eaves + chimney.y * rise - 0.3], size: [0.9, 0.9, 2.3], material: "brick");
  on_roof("window frame", window.x, window.y, 2, 2, 0.1, 0.14, "#f4f4f0", "plastic");
  on_roof("window pane", window.x + 0.12, window.y + 0.12, 1.76, 1.76, 0.02, 0.24, "#5f8fb4", "plastic");
  for b in panels {
    for x in 0..b.w - 1 { for y in 0..b.d / 2 - 1 {
      on_roof("frame", b.x + x + 0.02, b.y + 2 * y + 0.02, 0.96, 1.96, 0.05, 0.2, "#c9ced3", "steel");
      on_roof("panel", b.x + x + 0.06, b.y + 2 * y + 0.06, 0.88, 1.88, 0.02, 0.25, "#1d3a6b", "plastic");
    } }
  }
  place("door", at: [width / 2 - 0.5, 0.16, 0], size: [1, 0.3]);
  for x in [1.6, width - 3.0]: place("window", at: [x, 0.16, 0.9], size: [1.4, 0.3]);
  place("bush", at: [1, -1.2], scale: 0.9);
  place("bush", at: [width - 3, -1.4], scale: 1.1);
  place("tree", at: [-3.4, deep]);
  print(format("{} panels, {:.1} kW", number, number * 0.4));
}
