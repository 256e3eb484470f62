// std/layout.sol by hand-worked places: a is 2 wide and 1 deep at the origin, others are told against it.
import "std/layout.sol";
a = Rect(0, 0, 2, 1);
turned_a = Rect(0, 0, 2, 1, 1);
print([x1(a), x2(a), y1(a), y2(a)], [x2(turned_a), y2(turned_a)]);              // prints: [0, 2, 0, 1] [1, 2]
room = Rect(0, 0, 6, 4);
print(inside(a, room), inside(a, room, 1), inside(Rect(5, 0, 2, 1), room));      // prints: true false false
print(inside(Rect(4, 2, 2, 2), room), inside(Rect(4, 3, 2, 2), room));           // prints: true false
print(apart(a, Rect(2, 0, 1, 1)), apart(a, Rect(1, 0, 1, 1)), apart(a, Rect(0, 1, 2, 1)));  // prints: true false true
print(apart(a, Rect(3, 0, 1, 1), 1), apart(a, Rect(2, 0, 1, 1), 1), apart(a, Rect(2, 1, 1, 1), 1));  // prints: true false false
print(all_apart([a, Rect(2, 0, 1, 1), Rect(0, 1, 1, 1)]), all_apart([a, a]), all_apart([]));  // prints: true false true
print(lists_apart([a], [Rect(2, 0, 1, 1)]), lists_apart([a], [Rect(5, 5, 1, 1), a]));  // prints: true false
print(touching(a, Rect(2, 0, 1, 1)), touching(a, Rect(2, 1, 1, 1)), touching(a, Rect(3, 0, 1, 1)));  // prints: true false false
print(touching(a, Rect(1, 1, 2, 1)), touching(a, Rect(1, 1, 2, 1), 2));          // prints: true false
print(joined(a, Rect(0, 1, 2, 3)), joined(a, Rect(1, 1, 2, 1)), joined(a, Rect(2, 0, 1, 1)));  // prints: true false true
print(facing(Rect(0, 1, 1, 1, 0), a), facing(Rect(0, 1, 1, 1, 2), a), facing(Rect(1, -1, 1, 1, 2), a));  // prints: true false true
print(facing(Rect(-1, 0, 1, 1, 1), a), facing(Rect(2, 0, 1, 1, 3), a), facing(Rect(2, 1, 1, 1, 3), a));  // prints: true true false
print(facing(Rect(0, 2, 1, 1, 0), a, 1), facing(Rect(0, 1, 1, 1, 0), a, 1));     // prints: true false
print(flush(Rect(1, 3, 2, 1, 0), room), flush(Rect(1, 3, 2, 1, 2), room), flush(Rect(0, 1, 2, 1, 1), room));  // prints: true false true
print(flush(Rect(1, 0, 2, 1, 2), room), flush(Rect(5, 1, 2, 1, 3), room));       // prints: true true
print(row([a, Rect(2, 0, 1, 1), Rect(3, 0, 4, 2)]), row([a, Rect(2, 1, 1, 1)]), row([a]));  // prints: true false true
print(column([a, Rect(0, 1, 5, 1)]), column([a, Rect(1, 1, 1, 1)]));             // prints: true false
print(on_grid(Rect(4, 8, 4, 4), 4), on_grid(Rect(4, 7, 4, 4), 4));               // prints: true false
b = bounds([a, Rect(3, 2, 1, 1), Rect(-1, 0, 1, 1)]);
print([b.x, b.y, b.w, b.d]);                                                     // prints: [-1, 0, 5, 3]
f = front(a, 3);
print([f.x, f.y, f.w, f.d]);                                                     // prints: [0, -3, 2, 3]
things = repeat(range(1, 2), fun() { return anywhere("chair", 1, 1, 1, 0); });
assert(all_apart(things) and row(things) and all([t.turn == 2 for t in things]));
return [[t.x, t.y] for t in things];
// expect: [[0, 0]]
// expect: [[1, 0]]
// expect: [[0, 0], [1, 0]]
