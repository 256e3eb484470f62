// The twelve pentominoes in a box: each place of a piece is used or not, each piece lies once, and each cell is
// covered once.
import "pentomino_forms.sol";
param h = 6;
w = 60 / h;
fun one(xs) { return sum([if x then 1 else 0 for x in xs]) == 1; }
covers = [[] for i in 1..60];
for piece in pentominoes {
  ps = places(piece, w, h);
  used = [flip() for p in ps];
  assert(one(used));
  for i in 0..length(ps) - 1 { for c in ps[i]: covers[c] = covers[c] + [used[i]]; }
}
for c in covers: assert(one(c));
