// Four chairs at one side of a table that is three long.
import "std/layout.sol";

table = Thing("table", 3, 1, 0, 2, 2);
chairs = [Thing("chair", 1, 1, 0, range(0, 5), 3) for i in 1..4];
for chair in chairs: assert(facing(chair, table), "each chair faces the table");
// conflict: facing(chair, table) @ assert[0]; facing(chair, table) @ assert[1]
// conflict: facing(chair, table) @ assert[2]; facing(chair, table) @ assert[3]
assert(all_apart(chairs), "chairs do not overlap");  // conflict: all_apart(chairs)
