#pragma once
#include <string>

#include "engines/tiles/model/tileset.h"

namespace solitaire::tiles {

/// Encodes a picture as PNG.
std::string write_png(const Picture& picture);

/// Writes a map as PNG: each tile as its icon, or as a square of its colour with `side` pixels where the
/// tiles have no icons. Layers stand one below the other. Maps whose picture would have more than 2^27 pixels
/// get a pixel a tile. Where the tiles have at most 256 colours, the file has their numbers.
std::string write_png(const Grid& map, const Tileset& tileset, int side);

}  // namespace solitaire::tiles
