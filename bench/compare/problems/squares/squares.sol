// Six squares on a grid, none of which overlaps another.
import "std/layout.sol";

param squares = 6;
param size = 3;
param grid = 20;

all_squares = [Rect(range(0, grid - size), range(0, grid - size), size, size) for i in 1..squares];
assert(all_apart(all_squares));
