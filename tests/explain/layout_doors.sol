// Between two doors of a wall there is not enough wall for the cupboard.
wall = 8;
first = range(0, 7);
second = range(0, 7);
cupboard = range(0, wall - 4);

assert(first + 1 < second, "the doors do not touch");
assert(first + 1 <= cupboard, "the cupboard is right of the first door");  // conflict: first + 1 <= cupboard
assert(cupboard + 4 <= second, "and left of the second");  // conflict: cupboard + 4 <= second
assert(first >= 2, "the first door is not in the corner");  // conflict: first >= 2
assert(second <= 6, "nor is the second");  // conflict: second <= 6
