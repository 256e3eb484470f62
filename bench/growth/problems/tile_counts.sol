// A tile map of grass, roads, water and shores, whose edges meet, with a share of each.
param n = 12;
record Tile(name, n, e, s, w);
tiles = [Tile("grass", 0, 0, 0, 0), Tile("road_ns", 1, 0, 1, 0), Tile("road_ew", 0, 1, 0, 1),
         Tile("curve_ne", 1, 1, 0, 0), Tile("curve_es", 0, 1, 1, 0), Tile("curve_sw", 0, 0, 1, 1),
         Tile("curve_wn", 1, 0, 0, 1), Tile("cross", 1, 1, 1, 1), Tile("water", 2, 2, 2, 2),
         Tile("shore_n", 0, 3, 2, 3), Tile("shore_s", 2, 3, 0, 3), Tile("shore_e", 3, 0, 3, 2),
         Tile("shore_w", 3, 2, 3, 0), Tile("corner_ne", 0, 0, 3, 3), Tile("corner_es", 3, 0, 0, 3),
         Tile("corner_sw", 3, 3, 0, 0), Tile("corner_wn", 0, 3, 3, 0), Tile("bridge", 3, 1, 3, 1)];
map = [[choose(tiles) for x in 1..n] for y in 1..n];
for y in 0..n - 1 { for x in 0..n - 2: assert(map[y][x].e == map[y][x + 1].w); }
for y in 0..n - 2 { for x in 0..n - 1: assert(map[y][x].n == map[y + 1][x].s); }
for i in 0..n - 1: assert(map[i][0].w == 0 and map[i][n - 1].e == 0 and map[0][i].s == 0 and map[n - 1][i].n == 0);
fun share(names) { return count([tile.name in names for row in map for tile in row]); }
assert(share(["water"]) >= n * n / 10, "lakes");
assert(share(["road_ns", "road_ew", "cross"]) >= n * n / 5, "roads");
assert(share(["grass"]) <= n * n / 2, "not too many meadows");
return n;
