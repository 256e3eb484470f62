#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engines/tiles/read/json_object.h"
#include "engines/tiles/request/request.h"

namespace solitaire::tiles {

/// How members of DeBroglie's configuration are to be understood: the kind and the size of its map.
struct DebroglieMap {
  Point size{48, 48, 1};
  bool has_layers = false;
  /// Models of MagicaVoxel have y to the back, where maps here have it towards the viewer.
  bool is_flipped = false;
};

/// Returns the text with its letters from A to Z in small.
std::string in_small_letters(std::string text);

/// Returns what a tile is called here: numbers as text, colours in small letters, turned tiles as variants.
/// What is a quarter clockwise where y goes down is one counter-clockwise in flipped maps.
std::string debroglie_tile(const DebroglieMap& map, JsonObject& object, const char* member,
                           const nlohmann::json& value);
/// Returns the tiles that `tiles` lists, or the one that `tile` names.
std::vector<std::string> debroglie_tiles(const DebroglieMap& map, JsonObject& object,
                                         const char* tiles = "tiles", const char* tile = "tile");

/// Adds what one of the constraints asks for. Throws FileError for one that is not read.
void add_debroglie_constraint(JsonObject& object, const DebroglieMap& map, Request& request);
/// A tile is at the bottom of the map and nowhere else.
void add_debroglie_ground(const std::string& tile, const std::string& where, const DebroglieMap& map,
                          Request& request);

}  // namespace solitaire::tiles
