// The twelve pentominoes in a box: each chooses one of its places, and no two cover the same cell.
import "pentomino_forms.sol";
param h = 6;
lie = [choose(places(piece, 60 / h, h)) for piece in pentominoes];
assert(distinct([c for cells in lie for c in cells]));
