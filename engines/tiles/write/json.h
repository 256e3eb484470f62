#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "engines/tiles/model/tileset.h"

namespace solitaire::tiles {

/// Writes a map as {"size": [w, h, d], "tiles": [names], "data": [numbers of tiles]}, -1 for a hole, with the
/// members of `about` before.
std::string write_json(const Grid& map, const Tileset& tileset, const nlohmann::ordered_json& about);

}  // namespace solitaire::tiles
