// Grids: lists of rows, each a list of cells. cells[y][x] is the cell in column x of row y.

// A grid of what make() gives for each cell.
fun make_grid(w, h, make) { return [[make() for x in 1..w] for y in 1..h]; }

// A grid of what f(x, y) gives.
fun grid_of(w, h, f) { return [[f(x, y) for x in 0..w - 1] for y in 0..h - 1]; }

fun grid_width(cells) { return length(cells[0]); }
fun grid_height(cells) { return length(cells); }

// All cells in one list, row by row: cell (x, y) is at y * width + x, as std/graph.sol numbers them.
fun flat(cells) { return [cell for row in cells for cell in row]; }

fun columns(cells) { return [[row[x] for row in cells] for x in 0..grid_width(cells) - 1]; }

// Rows, columns, and the two long diagonals of a square.
fun lines(cells) {
  n = grid_width(cells);
  return cells + columns(cells) + [[cells[i][i] for i in 0..n - 1], [cells[i][n - 1 - i] for i in 0..n - 1]];
}

// The w x h cells from (x, y) on, as a grid.
fun window(cells, x, y, w, h) { return [row[x..x + w - 1] for row in cells[y..y + h - 1]]; }

// All windows of that size, in a list.
fun windows(cells, w, h) {
  return [window(cells, x, y, w, h) for y in 0..grid_height(cells) - h for x in 0..grid_width(cells) - w];
}

// The cells beside (x, y): up to four, or eight with the corners.
fun beside(cells, x, y, corners = false) {
  return [cells[b][a] for b in max(y - 1, 0)..min(y + 1, grid_height(cells) - 1)
          for a in max(x - 1, 0)..min(x + 1, grid_width(cells) - 1)
          if [a, b] != [x, y] and (corners or a == x or b == y)];
}

fun mirrored(cells) { return [reverse(row) for row in cells]; }

// Whether the grid is its own mirror image, left and right.
fun symmetric(cells) { return cells == mirrored(cells); }

// Puts a box for each cell into the scene: kind(cell) is the name of what is placed, or nil for nothing.
fun show_grid(cells, kind, height = 1) {
  for y, row in enumerate(cells) {
    for x, cell in enumerate(row) {
      name = kind(cell);
      if name != nil then place(name, at: [x, y], size: [1, 1, height]);
    }
  }
}
