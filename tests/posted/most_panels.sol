// As many panels as fit on a roof: eight cover it.
// $ solve --per-solution 5
// says: solution 1: 8
import "std/layout.sol";
param most = 8;
n = range(1, most);
fun make_panel() { return Rect(range(0, 36), range(0, 18), 9, 18); }
panels = repeat(n, make_panel);
for p in panels: assert(inside(p, Rect(0, 0, 36, 36)));
assert(all_apart(panels));
maximize(n);
return n;
