// The twelve pentominoes in a box: each place of a piece is used or not, each piece lies once, and each cell is
// covered once.
import "pentomino_forms.sol";
param h = 6;
fun one(xs) { return sum([if x then 1 else 0 for x in xs]) == 1; }
cover(60 / h, h, one);
