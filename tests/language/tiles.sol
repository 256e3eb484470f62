// All maps of 3x2 tiles whose neighbours are neighbours in the exemplar; counted by hand-written loops, too.
import "std/tiles.sol";
set = tiles([["g", "r", "g", "h"], ["r", "r", "r", "r"], ["h", "r", "g", "g"], ["g", "r", "h", "g"]]);
map = tile_map(set, 3, 2);
assert(not allowed(set.to_the_right, "h", "h"));
return map;
// expect solutions: 400
