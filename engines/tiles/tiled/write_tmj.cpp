#include <nlohmann/json.hpp>

#include "base/file_error.h"
#include "engines/tiles/read/file.h"
#include "engines/tiles/tiled/tileset_files.h"
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

/// Returns the visible layers of tiles with the map's tiles in place of their own.
Json layers_of(const Json& root, const Grid& map, const Tileset& tileset) {
  Json layers = Json::array();
  for (Json layer : root.at("layers")) {
    if (layer.at("type") != "tilelayer" || !layer.value("visible", true)) continue;
    for (const char* member : {"chunks", "encoding", "compression", "startx", "starty"}) layer.erase(member);
    Json data = Json::array();
    for (const Tile tile : map.tiles) data.push_back(gid_in_layer(tileset, tile, layers.size()));
    layer["data"] = std::move(data);
    layer["width"] = map.size.width();
    layer["height"] = map.size.height();
    layers.push_back(std::move(layer));
  }
  return layers.empty() ? root.at("the layers that were read") : layers;  // throws: there are none any more
}

/// Makes an empty map with a tileset alone.
Json map_around(const std::filesystem::path& file) {
  const TiledTileset tileset = read_tileset(file);
  return {{"type", "map"},
          {"version", "1.10"},
          {"orientation", "orthogonal"},
          {"renderorder", "right-down"},
          {"tilewidth", tileset.tile_width},
          {"tileheight", tileset.tile_height},
          {"tilesets", {{{"firstgid", 1}, {"source", file.filename().string()}}}},
          {"layers",
           {{{"type", "tilelayer"},
             {"id", 1},
             {"name", "tiles"},
             {"x", 0},
             {"y", 0},
             {"opacity", 1},
             {"visible", true}}}}};
}

}  // namespace

std::string write_tmj(const Grid& map, const Tileset& tileset, const std::filesystem::path& original,
                      const std::filesystem::path& folder) {
  try {
    Json root = is_tileset(original) ? map_around(original) : Json::parse(read_bytes(original));
    root["layers"] = layers_of(root, map, tileset);
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
