// The exemplar of tiles.sol, from a file.
import "std/tiles.sol";
set = tiles("parts/streets.txt");
map = tile_map(set, 3, 2);
return map;
// expect solutions: 400
