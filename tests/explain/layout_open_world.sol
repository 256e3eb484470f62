// However many chairs there are: too few for the tables or too many for the room.
import "std/layout.sol";

fun make_chair() { return range(0, 5); }
// conflict: chairs[0]/range is at least 0; chairs[2]/range is at most 5
chairs = repeat(range(0, 4), make_chair);
assert(length(chairs) > 2, "enough chairs");  // conflict: length(chairs) > 2
for i in 0..length(chairs) - 2: assert(chairs[i] + 2 < chairs[i + 1], "elbow room");
// conflict: chairs[i] + 2 < chairs[i + 1] @ assert[0]; chairs[i] + 2 < chairs[i + 1] @ assert[1]
