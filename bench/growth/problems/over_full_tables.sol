// Tables of 3 by 2, all turned alike, of which the room holds fewer than are asked for: no solution.
import "std/layout.sol";
param side = 8;
n = side * side / 6 + 1;
fun make_table() { return Rect(range(0, side - 3), range(0, side - 2), 3, 2); }
tables = repeat(n, make_table);
assert(all_apart(tables));
return n;
