// The sofa is to stand further from the television than the room is deep.
import "std/layout.sol";

param distance = 5;
room = Rect(0, 0, 5, 7);
television = Thing("cabinet", 2, 1, 0, range(0, 5), range(0, 7));
sofa = Thing("sofa", 2, 1, 2, range(0, 5), range(0, 7));  // conflict: sofa.y is at least 0

assert(flush(television, room), "the television is at the wall");  // conflict: flush(television, room)
assert(inside(sofa, room));
assert(y1(television) - y2(sofa) > distance, "not too near");  // conflict: y1(television) - y2(sofa) > distance
assert(x1(sofa) == x1(television));
