// Row by row, what covers a cell that nothing covers yet: a domino to the right or one downwards.
param width = 4;
param height = 4;
covered = [[false for x in 1..width] for y in 1..height];
for y in 0..height - 1 {
  for x in 0..width - 1 {
    if covered[y][x] { continue; }
    covered[y][x] = true;
    if flip() then x2, y2 = x + 1, y;
    else x2, y2 = x, y + 1;
    assert(not covered[y2][x2]);
    covered[y2][x2] = true;
  }
}
