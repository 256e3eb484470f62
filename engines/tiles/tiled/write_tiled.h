#pragma once
#include <filesystem>
#include <string>

#include "engines/tiles/model/tileset.h"

namespace solitaire::tiles {

/// Writes a map as Tiled's .tmx, after the pattern of the map `original` that was the exemplar: with its
/// tilesets and properties, and the flags of turned tiles, but without its layers that are hidden or have no
/// tiles. Where the exemplar was a tileset (.tsx, .tsj), the map has this alone. The names of tilesets and
/// pictures are relative to the folder that the file will be in.
std::string write_tmx(const Grid& map, const Tileset& tileset, const std::filesystem::path& original,
                      const std::filesystem::path& folder);

/// The same as .tmj, after the pattern of a .tmj or around a tileset.
std::string write_tmj(const Grid& map, const Tileset& tileset, const std::filesystem::path& original,
                      const std::filesystem::path& folder);

/// Returns the gid that a tile has in a layer; 0 for none.
std::uint32_t gid_in_layer(const Tileset& tileset, Tile tile, std::size_t layer);

/// Returns the name, for a file in `folder`, of what a file beside `original` names so.
std::string moved_name(const std::string& name, const std::filesystem::path& original,
                       const std::filesystem::path& folder);

}  // namespace solitaire::tiles
