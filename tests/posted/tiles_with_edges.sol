// Road tiles whose edges meet, and none leads out: closed rings.
// $ solve --all
// says: 16 solutions
// says: proved that there is no other
param n = 3;
record Tile(name, n, e, s, w);
tiles = [Tile("grass", 0, 0, 0, 0), Tile("road_ns", 1, 0, 1, 0), Tile("road_ew", 0, 1, 0, 1), Tile("curve_ne", 1, 1, 0, 0),
         Tile("curve_es", 0, 1, 1, 0), Tile("curve_sw", 0, 0, 1, 1), Tile("curve_wn", 1, 0, 0, 1), Tile("cross", 1, 1, 1, 1)];
map = [[choose(tiles) for x in 0..n - 1] for y in 0..n - 1];
for y in 0..n - 1 {
  for x in 0..n - 1 {
    if x < n - 1 then assert(map[y][x].e == map[y][x + 1].w, "edges meet, east");
    if y < n - 1 then assert(map[y][x].n == map[y + 1][x].s, "edges meet, north");
    if x == 0 then assert(map[y][x].w == 0);
    if x == n - 1 then assert(map[y][x].e == 0);
    if y == 0 then assert(map[y][x].s == 0);
    if y == n - 1 then assert(map[y][x].n == 0);
  }
}
