// The twelve pentominoes in a box: each place of a piece is used or not, each piece lies once, and each cell is
// covered once. That only one of several is so is said of each two of them.
import "pentomino_forms.sol";
param h = 6;
fun one(xs) { return all(any(xs), all([not (a and b) for a, b in pairs(xs)])); }
cover(60 / h, h, one);
