// $ solve
// status: 1
// says: 17 things that do not overlap need an area of 68, and lie within one of 64
import "std/layout.sol";
room = Rect(0, 0, 8, 8);
tables = [Rect(range(0, 8), range(0, 8), 2, 2) for i in 1..17];
for t in tables: assert(inside(t, room));
assert(all_apart(tables));
