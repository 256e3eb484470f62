// Open tours of a knight on 3 x 4 squares from a corner.
// $ solve --all
// says: 2 solutions
p = [range(0, 11) for i in 0..11];
assert(distinct(p));
fun jump(a, b) {
  dx = abs(a % 4 - b % 4);
  dy = abs(a / 4 - b / 4);
  return any(all(dx == 1, dy == 2), all(dx == 2, dy == 1));
}
for i in 0..10: assert(jump(p[i], p[i + 1]));
assert(p[0] == 0);
return p;
