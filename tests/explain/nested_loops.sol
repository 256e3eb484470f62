// One number for each loop.
for row in 0..1 {
  for column in 0..2 {
    cell = range(0, 3);
    assert(cell + row * column <= 3 and (cell > 1 or row == 0));
    // conflict: cell + row * column <= 3 @ assert[1][2]; cell > 1 or row == 0 @ assert[1][2]
  }
}
