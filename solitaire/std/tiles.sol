// Maps of tiles that are told by an exemplar: two tiles may be beside each other if they are somewhere in it.
//
// An exemplar and a map are lists of rows from the top, each a list of tiles, as in std/grid.sol. A tile is any value that
// stays the same, such as a name.

// What an exemplar says: its tiles, and for each of them those that may be to its right, and those that may be below it.
record Tiles(all, to_the_right, below);

fun tiles(exemplar) {
  found = [];
  for row in exemplar {
    for tile in row: if not contains(found, tile) then found = found + [tile];
  }
  to_the_right = [[] for tile in found];
  below = [[] for tile in found];
  for y, row in enumerate(exemplar) {
    for x, tile in enumerate(row) {
      i = index_of(found, tile);
      if x + 1 < length(row) then to_the_right[i] = with_tile(to_the_right[i], row[x + 1]);
      if y + 1 < length(exemplar) then below[i] = with_tile(below[i], exemplar[y + 1][x]);
    }
  }
  return Tiles(found, to_the_right, below);
}

fun with_tile(list, tile) { return if contains(list, tile) then list else list + [tile]; }

// Whether `second` may follow `first`, where `next` has for each tile of `all` those that may follow it.
fun allowed(all_tiles, next, first, second) {
  return all([any(first != tile, contains(next[i], second)) for i, tile in enumerate(all_tiles)]);
}

// Chooses a map of w x h tiles all of whose neighbours are neighbours in the exemplar.
fun tile_map(set, w, h) {
  site = [[choose(set.all) for x in 1..w] for y in 1..h];
  for y in 0..h - 1 {
    for x in 0..w - 1 {
      if x + 1 < w then assert(allowed(set.all, set.to_the_right, site[y][x], site[y][x + 1]), "neighbours in a row");
      if y + 1 < h then assert(allowed(set.all, set.below, site[y][x], site[y + 1][x]), "neighbours in a column");
    }
  }
  return site;
}

// For each site of a map, row by row, whether it has one of these tiles: what std/graph.sol asks, with grid_graph(w, h).
fun is_one_of(map, some) { return [contains(some, tile) for row in map for tile in row]; }
