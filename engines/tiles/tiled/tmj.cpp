#include <fmt/format.h>

#include "engines/tiles/read/file.h"
#include "engines/tiles/read/json_object.h"
#include "engines/tiles/tiled/tiled_map.h"
#include "engines/tiles/tiled/tileset_files.h"

namespace solitaire::tiles {
namespace {

constexpr std::int64_t kLargestExtent = 1 << 20;

int small_number(JsonObject& object, const char* member) {
  return object.has(member) ? static_cast<int>(object.number(member, -kLargestExtent, kLargestExtent)) : 0;
}

/// Reads the first Wang set of a tileset, if there is one.
void read_wang_set(const std::string& file, JsonObject& tileset, TiledTileset& to) {
  std::vector<JsonObject> sets = tileset.objects("wangsets");
  if (sets.empty()) return;
  std::vector<std::string> colors;
  for (JsonObject& color : sets.front().objects("colors")) {
    const std::string name = color.text_or("name", "");
    colors.push_back(name.empty() ? fmt::format("colour {}", colors.size() + 1) : name);
  }
  for (JsonObject& tile : sets.front().objects("wangtiles")) {
    const nlohmann::json& ids = tile.at("wangid");
    std::vector<std::int64_t> numbers;
    for (const nlohmann::json& id : ids) {
      if (!id.is_number_unsigned() || id.get<std::uint64_t>() > UINT32_MAX)
        tile.fail("wangid", "has what is no colour");
      numbers.push_back(id.get<std::int64_t>());
    }
    to.wang[static_cast<std::uint32_t>(tile.number("tileid", 0, UINT32_MAX))] =
        wang_colors(file, numbers, colors);
  }
}

double coordinate(JsonObject& object, const char* member) {
  return object.has(member) ? object.real(member, -1e9, 1e9) : 0;
}

void read_pin_layer(const std::string& file, JsonObject& root, JsonObject& layer, TiledMap& map) {
  const int width = small_number(root, "tilewidth"), height = small_number(root, "tileheight");
  for (JsonObject& object : layer.objects("objects")) {
    map.pins.push_back(pin_of(file,
                              {object.text_or("name", ""), coordinate(object, "x"), coordinate(object, "y"),
                               coordinate(object, "width"), coordinate(object, "height")},
                              width, height));
  }
}

TiledProperties properties_of(const std::string& file, JsonObject& tile) {
  TiledProperties properties;
  for (JsonObject& property : tile.objects("properties")) {
    const std::string name = property.text_or("name", "");
    if (name == "name") properties.name = property.text("value");
    if (name == "asset") properties.asset = property.text("value");
    if (name == "weight") properties.weight = checked_weight(file, property.real("value", 0, 1e9));
    if (name == "rotate") properties.rotates = property.flag("value");
  }
  return properties;
}

TiledTileset tileset_of(JsonObject& object, const std::filesystem::path& file) {
  TiledTileset tileset;
  tileset.name = object.text_or("name", "");
  tileset.tile_width = small_number(object, "tilewidth");
  tileset.tile_height = small_number(object, "tileheight");
  tileset.columns = small_number(object, "columns");
  tileset.spacing = small_number(object, "spacing");
  tileset.margin = small_number(object, "margin");
  if (object.has("image")) tileset.image = file_beside(file, object.text("image"));
  for (JsonObject& tile : object.objects("tiles")) {
    const auto id = static_cast<std::uint32_t>(tile.number("id", 0, UINT32_MAX));
    if (tile.has("properties")) tileset.properties[id] = properties_of(file.string(), tile);
  }
  read_wang_set(file.string(), object, tileset);
  return tileset;
}

void read_data(const std::string& file, JsonObject& layer, JsonObject& holder, TiledLayers& to) {
  const std::int64_t width = holder.number("width", 1, kLargestExtent),
                     height = holder.number("height", 1, kLargestExtent);
  const std::int64_t x = small_number(holder, "x"), y = small_number(holder, "y");
  const auto count = static_cast<std::size_t>(width * height);
  const nlohmann::json& data = holder.at("data");
  std::vector<std::uint32_t> gids;
  if (data.is_string()) {
    gids = decode_gids(file, data.get<std::string>(), layer.text_or("encoding", "csv"),
                       layer.text_or("compression", ""), count);
  } else if (data.is_array()) {
    for (const nlohmann::json& gid : data) {
      if (!gid.is_number_unsigned() || gid.get<std::uint64_t>() > UINT32_MAX)
        holder.fail("data", "has what is no gid");
      gids.push_back(gid.get<std::uint32_t>());
    }
  } else {
    holder.fail("data", "is neither a list nor a text");
  }
  to.add(file, x, y, width, height, gids);
}

}  // namespace

TiledTileset read_tsj(const std::filesystem::path& path) {
  const std::string file = path.string();
  const nlohmann::json json = parse_json(file, read_bytes(path));
  JsonObject object(file, json, "");
  return tileset_of(object, path);
}

TiledMap read_tmj(const std::filesystem::path& path, const std::string& bytes, bool with_tilesets) {
  const std::string file = path.string();
  const nlohmann::json json = parse_json(file, bytes);
  JsonObject root(file, json, "");
  const std::string orientation = root.text_or("orientation", "orthogonal");
  if (orientation != "orthogonal")
    root.fail("orientation", fmt::format("is '{}'; orthogonal maps are read", orientation));
  TiledMap map;
  for (JsonObject& each : root.objects("tilesets")) {
    if (!with_tilesets) break;
    map.tilesets.push_back(each.has("source") ? read_tileset(file_beside(path, each.text("source")))
                                              : tileset_of(each, path));
    map.tilesets.back().first_gid = static_cast<std::uint32_t>(each.number("firstgid", 1, UINT32_MAX));
  }
  TiledLayers layers;
  for (JsonObject& each : root.objects("layers")) {
    if (each.text_or("type", "") == "objectgroup" && each.text_or("name", "") == "pins")
      read_pin_layer(file, root, each, map);
    if (each.text_or("type", "") != "tilelayer" || (each.has("visible") && !each.flag("visible"))) continue;
    layers.begin(file);
    for (JsonObject& chunk : each.objects("chunks")) read_data(file, each, chunk, layers);
    if (!each.has("chunks")) read_data(file, each, each, layers);
  }
  layers.write_to(file, map);
  return map;
}

}  // namespace solitaire::tiles
