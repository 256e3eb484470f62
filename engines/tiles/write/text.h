#pragma once
#include <string>

#include "engines/tiles/model/tileset.h"

namespace solitaire::tiles {

/// Writes a map as characters, as read_text() reads it. Tiles without a character of their own get one.
std::string write_text(const Grid& map, const Tileset& tileset);

}  // namespace solitaire::tiles
