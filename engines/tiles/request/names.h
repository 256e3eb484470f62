#pragma once
#include <string>
#include <vector>

#include "engines/tiles/model/tile_mask.h"
#include "engines/tiles/model/tileset.h"
#include "engines/tiles/request/request.h"

namespace solitaire::tiles {

/// Returns names in quotes, with commas between them.
std::string quoted(const std::vector<std::string>& names);

/// Returns the tile that somebody calls so: by its name, or by its number in the map of Tiled or the model of
/// MagicaVoxel that it was read from. Throws RequestError.
Tile tile_called(const Tileset& tileset, const std::string& name);
TileMask tile_set(const Tileset& tileset, const std::vector<std::string>& names);

/// Returns the zones that exemplars name, in the order of their first appearance.
std::vector<std::string> zone_names(const Request& request);
/// Returns the place of a zone among these. Throws RequestError.
std::uint8_t zone_number(const std::vector<std::string>& names, const std::string& zone);

/// Returns the sides that letters name: l, r, t, b, and u and d for up and down in maps of several layers.
/// Throws RequestError.
Sides sides_of(const std::string& letters);

}  // namespace solitaire::tiles
