// The bed stands below the window, where the door opens.
import "std/layout.sol";

room = Rect(0, 0, 4, 4);
bed = Thing("bed", 2, 2, 0, range(0, 4), range(0, 4));
door = Thing("door", 1, 1, 0, 2, 3);

assert(flush(bed, room), "the head is at a wall");  // conflict: flush(bed, room)
assert(x1(bed) >= 1 and x2(bed) <= 3, "below the window");  // conflict: x1(bed) >= 1
assert(apart(bed, front(door, 2)), "the door opens");  // conflict: apart(bed, front(door, 2))
