#pragma once
#include <string>

#include "engines/tiles/model/tileset.h"

namespace solitaire::tiles {

/// Writes a map as a model of MagicaVoxel, as read_vox() reads it. A tile that has no colour number of its
/// own gets a free one; the tile "empty" and holes are left out. Throws std::length_error for maps with more
/// than 256 sites along an axis.
std::string write_vox(const Grid& map, const Tileset& tileset);

}  // namespace solitaire::tiles
