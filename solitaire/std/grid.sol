// Grids: lists of rows, each a list of cells. cells[y][x] is the cell in column x of row y.

// A grid of what make() gives for each cell.
fun make_grid(w, h, make) { return [[make() for x in 1..w] for y in 1..h]; }

// A grid of what f(x, y) gives.
fun grid_of(w, h, f) { return [[f(x, y) for x in 0..w - 1] for y in 0..h - 1]; }

fun grid_width(cells) { return length(cells[0]); }
fun grid_height(cells) { return length(cells); }

// [x, y, cell] of each cell, row by row: for x, y, cell in each_cell(cells) { ... }
fun each_cell(cells) { return [[x, y, cell] for y, row in enumerate(cells) for x, cell in enumerate(row)]; }

// All cells in one list, row by row: cell (x, y) is at y * width + x, as std/graph.sol numbers them.
fun flat(cells) { return [cell for row in cells for cell in row]; }

// A list as a grid of that width: in_rows(flat(cells), grid_width(cells)) is cells.
fun in_rows(list, w) { return [list[y * w..y * w + w - 1] for y in 0..length(list) / w - 1]; }

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

// The turn at which a thing in the cell (x, y) has its front towards a cell beside it that is `wanted`; nil if there is none.
fun turn_to(cells, x, y, wanted) {
  for turn, step in enumerate([[0, -1], [1, 0], [0, 1], [-1, 0]]) {
    a, b = x + step[0], y + step[1];
    if a in 0..grid_width(cells) - 1 and b in 0..grid_height(cells) - 1 then { if cells[b][a] == wanted then return turn; }
  }
  return nil;
}

// ---- showing; in the output, where it costs the solver nothing

// What place() takes as the outline: of a cell of a region. Corners at which the region ends on both sides are rounded, so that
// all its cells together have a smooth edge. is_in(x, y) says of any place whether it belongs to the region.
fun rounded_cell(x, y, is_in) {
  return [point for dx, dy in [[1, 1], [-1, 1], [-1, -1], [1, -1]] for point in rounded_corner(x, y, dx, dy, is_in)];
}

fun rounded_corner(x, y, dx, dy, is_in) {
  u, v = x + (dx + 1) / 2, y + (dy + 1) / 2;
  if is_in(x + dx, y) or is_in(x, y + dy) then return [[u, v]];
  along = [[u, v - 0.45 * dy], [u - 0.13 * dx, v - 0.13 * dy], [u - 0.45 * dx, v]];
  return if dx == dy then along else reverse(along);
}

// Puts a box for each cell into the scene: kind(cell) is the name of what is placed, or nil for nothing.
fun show_grid(cells, kind, height = 1) {
  for x, y, cell in each_cell(cells) {
    name = kind(cell);
    if name != nil then place(name, at: [x, y], size: [1, 1, height]);
  }
}
