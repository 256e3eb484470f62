// Shows: as many solar panels on a roof as fit, in blocks, away from chimney and window.
import "std/layout.sol";

param width = 12;
param height = 8;
param blocks = 3;

chimney, window = Rect(3, 5, 1, 1), Rect(8, 2, 2, 2);
roof = Rect(0, 0, width, height);

// A block of panels, each 1 wide and 2 high.
fun block() { return Rect(range(0, width - 2), range(0, height - 2), range(2, 8), range(2, 6, 2)); }
panels = [block() for i in 1..blocks];
for b in panels: assert(inside(b, roof) and apart(b, chimney, 1) and apart(b, window, 1), "in the sun");
assert(all_apart(panels, 1), "a way to clean them");
number = sum([b.w * (b.d / 2) for b in panels]);
assert(number >= 18, "enough power");
prefer(number >= 22, 2);

place("roof", at: [0, 0, -0.2], size: [width, height, 0.2], color: "maroon");
place("chimney", at: [chimney.x, chimney.y], size: [1, 1, 2], material: "brick");
place("window", at: [window.x, window.y], size: [2, 2, 0.1], color: "white");
output {
  for b in panels {
    for x in 0..b.w - 1 { for y in 0..b.d / 2 - 1 {
      place("panel", at: [b.x + x + 0.03, b.y + 2 * y + 0.03], size: [0.94, 1.94, 0.1], color: "navy");
    } }
  }
  print(format("{} panels, {:.1} kW", number, number * 0.4));
}
