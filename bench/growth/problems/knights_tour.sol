// An open knight's tour from the corner: the cell of each step.
param n = 5;
cell = [range(0, n * n - 1) for i in 0..n * n - 1];
assert(distinct(cell));
fun jump(a, b) {
  dx = abs(a % n - b % n);
  dy = abs(a / n - b / n);
  return any(all(dx == 1, dy == 2), all(dx == 2, dy == 1));
}
for i in 0..n * n - 2: assert(jump(cell[i], cell[i + 1]));
assert(cell[0] == 0);
return cell;
