// A tile map of grass, roads, water and shores, whose edges meet, with a share of each.
import "edge_tiles.sol";
param n = 12;
map = [[choose(tiles) for x in 1..n] for y in 1..n];
for y in 0..n - 1 { for x in 0..n - 2: assert(map[y][x].e == map[y][x + 1].w); }
for y in 0..n - 2 { for x in 0..n - 1: assert(map[y][x].n == map[y + 1][x].s); }
for i in 0..n - 1: assert(map[i][0].w == 0 and map[i][n - 1].e == 0 and map[0][i].s == 0 and map[n - 1][i].n == 0);
fun share(names) { return count([tile.name in names for row in map for tile in row]); }
assert(share(["water"]) >= n * n / 10, "lakes");
assert(share(["road_ns", "road_ew", "cross"]) >= n * n / 5, "roads");
assert(share(["grass"]) <= n * n / 2, "not too many meadows");
return n;
