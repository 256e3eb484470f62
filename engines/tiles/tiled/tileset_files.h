#pragma once
#include <cstdint>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "engines/tiles/model/tileset.h"
#include "engines/tiles/tiled/tiled_map.h"

namespace solitaire::tiles {

/// Reads a tileset of its own file (.tsx, .tsj). Throws FileError.
TiledTileset read_tileset(const std::filesystem::path& path);
TiledTileset read_tsx(const std::filesystem::path& path);
TiledTileset read_tsj(const std::filesystem::path& path);

/// Returns whether a file is a tileset of Tiled (.tsx, .tsj).
bool is_tileset(const std::filesystem::path& file);

/// Returns whether a file is a map of Tiled (.tmx, .tmj).
bool is_tiled(const std::filesystem::path& file);

/// Adds the tiles of a tileset that its first Wang set labels, with the labels as their edges. Throws
/// FileError.
void read_tiles_of(const std::filesystem::path& path, Tileset& tileset);

/// Adds the tiles with these numbers in a map that has this tileset alone, counted from 1. Number 0 is the
/// tile "empty". Throws FileError.
void read_numbered_tiles_of(const std::filesystem::path& path, const std::set<std::uint32_t>& numbers,
                            Tileset& tileset);

/// Reads the pins of a map: the rectangles of its object layer "pins". Throws FileError.
std::vector<TiledPin> read_pins(const std::filesystem::path& path);

/// Reads a Tiled map as an exemplar. A tile is a gid with its flags; its name is the property "name" or the
/// tileset's name and its number, followed by the letters of its flags. Throws FileError.
Grid read_tiled(const std::filesystem::path& path, Tileset& tileset, bool open);

}  // namespace solitaire::tiles
