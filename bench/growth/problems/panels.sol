// As many solar panels as can be on a roof.
import "std/layout.sol";
param most = 20;
n = range(1, most);
fun make_panel() { return Rect(range(0, 110), range(0, 53), 10, 17); }
panels = repeat(n, make_panel);
assert(all_apart(panels));
maximize(n);
return n;
