#pragma once
#include <filesystem>
#include <string>

#include "engines/tiles/model/tileset.h"
#include "engines/tiles/tiled/tiled_map.h"

namespace solitaire::tiles {

/// Reads a tileset of its own file (.tsx, .tsj). Throws FileError.
TiledTileset read_tileset(const std::filesystem::path& path);
TiledTileset read_tsx(const std::filesystem::path& path);
TiledTileset read_tsj(const std::filesystem::path& path);

/// Reads a Tiled map as an exemplar. A tile is a gid with its flags; its name is the property "name" or the
/// tileset's name and its number, followed by the letters of its flags. Throws FileError.
Grid read_tiled(const std::filesystem::path& path, Tileset& tileset, bool open);

}  // namespace solitaire::tiles
