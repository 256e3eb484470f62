#include <nlohmann/json.hpp>

#include "base/file_error.h"
#include "engines/tiles/read/file.h"
#include "engines/tiles/tiled/write_tiled.h"

namespace solitaire::tiles {
namespace {

using Json = nlohmann::ordered_json;

void move_member(Json& object, const char* member, const std::filesystem::path& original,
                 const std::filesystem::path& folder) {
  if (object.contains(member)) {
    object[member] = moved_name(object[member].get<std::string>(), original, folder);
  }
}

/// Returns the first visible layer of tiles with the map's tiles in place of its own.
Json layer_of(const Json& root, const Grid& map, const Tileset& tileset) {
  for (Json layer : root.at("layers")) {
    if (layer.at("type") != "tilelayer" || !layer.value("visible", true)) continue;
    for (const char* member : {"chunks", "encoding", "compression", "startx", "starty"}) layer.erase(member);
    Json data = Json::array();
    for (const Tile tile : map.tiles) data.push_back(tile == kHole ? 0 : tileset[tile].gid.value_or(0));
    layer["data"] = std::move(data);
    layer["width"] = map.size.width();
    layer["height"] = map.size.height();
    return layer;
  }
  return root.at("the layer that was read");  // throws: there is none any more
}

}  // namespace

std::string write_tmj(const Grid& map, const Tileset& tileset, const std::filesystem::path& original,
                      const std::filesystem::path& folder) {
  try {
    Json root = Json::parse(read_bytes(original));
    root["layers"] = Json::array({layer_of(root, map, tileset)});
    for (Json& each : root["tilesets"]) {
      move_member(each, "source", original, folder);
      move_member(each, "image", original, folder);
    }
    root["width"] = map.size.width();
    root["height"] = map.size.height();
    root["infinite"] = false;
    return root.dump(1) + "\n";
  } catch (const nlohmann::json::exception&) {
    throw FileError(original.string(), "has changed");
  }
}

}  // namespace solitaire::tiles
