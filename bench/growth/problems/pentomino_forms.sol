// The twelve pentominoes, each with all its forms: turned, and the other side up.
pentominoes = [[[0, 1], [0, 2], [1, 0], [1, 1], [2, 1]], [[0, 0], [0, 1], [0, 2], [0, 3], [0, 4]],
               [[0, 0], [0, 1], [0, 2], [0, 3], [1, 0]], [[0, 0], [0, 1], [0, 2], [1, 2], [1, 3]],
               [[0, 0], [0, 1], [0, 2], [1, 0], [1, 1]], [[0, 0], [0, 1], [0, 2], [1, 1], [2, 1]],
               [[0, 0], [0, 1], [0, 2], [1, 0], [1, 2]], [[0, 0], [0, 1], [0, 2], [1, 0], [2, 0]],
               [[0, 0], [0, 1], [1, 1], [1, 2], [2, 2]], [[0, 1], [1, 0], [1, 1], [1, 2], [2, 1]],
               [[0, 0], [0, 1], [0, 2], [0, 3], [1, 1]], [[0, 0], [0, 1], [1, 1], [2, 1], [2, 2]]];

fun turned(cells) { return [[c[1], -c[0]] for c in cells]; }
fun mirrored(cells) { return [[c[0], -c[1]] for c in cells]; }
// The cells in order, from the corner on.
fun in_corner(cells) {
  top = min([c[0] for c in cells]);
  left = min([c[1] for c in cells]);
  return [[y, x] for y in 0..4 for x in 0..4 if contains(cells, [y + top, x + left])];
}
fun forms(cells) {
  found = [];
  for side in [cells, mirrored(cells)] {
    form = side;
    for turn in 1..4 {
      form = turned(form);
      if not contains(found, in_corner(form)) { found = found + [in_corner(form)]; }
    }
  }
  return found;
}
// Where a piece can lie in a box: the numbers of the cells that it covers there, row by row.
fun places(piece, w, h) {
  return [[(y + c[0]) * w + x + c[1] for c in form]
          for form in forms(piece) for y in 0..h - 1 for x in 0..w - 1
          if max([y + c[0] for c in form]) < h and max([x + c[1] for c in form]) < w];
}
// Covers a box: each place of a piece is used or not, and of the places of a piece, and of those that cover a cell,
// exactly one is used, as one(xs) says it.
fun cover(w, h, one) {
  covers = [[] for i in 1..w * h];
  for piece in pentominoes {
    ps = places(piece, w, h);
    used = [flip() for p in ps];
    assert(one(used));
    for i in 0..length(ps) - 1 { for c in ps[i]: covers[c] = covers[c] + [used[i]]; }
  }
  for c in covers: assert(one(c));
}
