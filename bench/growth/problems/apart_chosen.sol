// n chosen boxes of 3 by 3 in a square room that they fill by a third, so that the room grows with n.
import "std/layout.sol";
param n = 100;
param side = 52;
fun make_box() { return Rect(range(0, side - 3), range(0, side - 3), 3, 3); }
boxes = repeat(n, make_box);
assert(all_apart(boxes));
return n;
