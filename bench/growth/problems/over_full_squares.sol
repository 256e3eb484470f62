// One table of 2 by 2 more than a square room has space for: no solution.
import "std/layout.sol";
param side = 4;
n = side * side / 4 + 1;
fun make_table() { return Rect(range(0, side - 2), range(0, side - 2), 2, 2); }
tables = repeat(n, make_table);
assert(all_apart(tables));
return n;
