// Maps of tiles that are told by an exemplar: two tiles may be beside each other if they are somewhere in it.
//
// A map is a list of rows from the top, each a list of tiles, as in std/grid.sol.

// What an exemplar says: its tiles; as tables for allowed() those that may be to the right of each, and those that
// may be below it; and what it was learned from.
record Tiles(all, to_the_right, below, source);

// Learns from an exemplar: a map in the program, whose tiles are any values that stay the same, such as names; or the
// name of a file that `solitaire tiles` reads (.txt, .png, .tmx, .tmj, .vox, .json, .tiles.json), relative to the script.
// The tiles of a file are names.
fun tiles(exemplar) {
  all_tiles, to_the_right, below, source = tile_pairs(exemplar);
  return Tiles(all_tiles, to_the_right, below, source);
}

// Chooses a map of w x h tiles all of whose neighbours are neighbours in the exemplar.
fun tile_map(set, w, h) {
  site = [[choose(set.all) for x in 1..w] for y in 1..h];
  tile_sites(w, h, set.source);
  for y in 0..h - 1 {
    for x in 0..w - 1 {
      if x + 1 < w then assert(tile_neighbors(set.to_the_right, site[y][x], site[y][x + 1]), "neighbours in a row");
      if y + 1 < h then assert(tile_neighbors(set.below, site[y][x], site[y + 1][x]), "neighbours in a column");
    }
  }
  return site;
}

// For each site of a map, row by row, whether it has one of these tiles: what std/graph.sol asks, with grid_graph(w, h).
fun is_one_of(map, some) { return [contains(some, tile) for row in map for tile in row]; }
