// What was liked is kept, and does not go with what is new.
// pin: desk/make/x=4
// pin: desk/make/y=0
import "std/layout.sol";

room = Rect(0, 0, 6, 4);
fun make(kind, w) { x, y = range(-1, 7), range(-1, 7); return Thing(kind, w, 1, 0, x, y); }
// conflict: desk/make/x is 4, by --pin 'desk/make/x=4'
// conflict: desk/make/y is 0, by --pin 'desk/make/y=0'
fun desk() { return make("desk", 2); }
d = desk();
s = make("sofa", 4);
assert(inside(s, room), "the sofa is in the room");  // conflict: inside(s, room)
assert(s.y == 0, "it is at the window");  // conflict: s.y == 0
assert(apart(d, s, gap: 1), "a way between them");  // conflict: apart(d, s, gap: 1)
