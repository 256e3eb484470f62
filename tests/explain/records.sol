// Fields of records, whichever record it is.
record Chair(x, legs);
record Sofa(x, cushions);
seat = if flip() then Chair(range(0, 4), 4) else Sofa(range(5, 9), 2);
assert(seat.x > 3 and seat.x < 6);  // conflict: seat.x > 3; seat.x < 6
assert(seat.x != 4 and seat.x != 5);  // conflict: seat.x != 4; seat.x != 5
