// Tiles of grass, roads, water and shores, with the kind of each edge.
record Tile(name, n, e, s, w);
tiles = [Tile("grass", 0, 0, 0, 0), Tile("road_ns", 1, 0, 1, 0), Tile("road_ew", 0, 1, 0, 1),
         Tile("curve_ne", 1, 1, 0, 0), Tile("curve_es", 0, 1, 1, 0), Tile("curve_sw", 0, 0, 1, 1),
         Tile("curve_wn", 1, 0, 0, 1), Tile("cross", 1, 1, 1, 1), Tile("water", 2, 2, 2, 2),
         Tile("shore_n", 0, 3, 2, 3), Tile("shore_s", 2, 3, 0, 3), Tile("shore_e", 3, 0, 3, 2),
         Tile("shore_w", 3, 2, 3, 0), Tile("corner_ne", 0, 0, 3, 3), Tile("corner_es", 3, 0, 0, 3),
         Tile("corner_sw", 3, 3, 0, 0), Tile("corner_wn", 0, 3, 3, 0), Tile("bridge", 3, 1, 3, 1)];
