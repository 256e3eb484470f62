#pragma once
#include <string>
#include <string_view>

#include "engines/tiles/model/tileset.h"

namespace solitaire::tiles {

/// Reads a model of MagicaVoxel. A colour of its palette is a tile, named "voxel 7" by its number; what is
/// empty is the tile "empty". The file has z upwards and y into the depth, where maps have y down the page.
/// Throws FileError.
Grid read_vox(const std::string& name, std::string_view bytes, Tileset& tileset, bool open);

}  // namespace solitaire::tiles
