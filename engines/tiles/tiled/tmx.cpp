#include <charconv>
#include <fmt/format.h>
#include <pugixml.hpp>

#include "base/file_error.h"
#include "engines/tiles/read/file.h"
#include "engines/tiles/tiled/tiled_map.h"
#include "engines/tiles/tiled/tileset_files.h"

namespace solitaire::tiles {
namespace {

/// Parses XML. pugixml resolves no entities but the five of XML itself, and reads no other file.
pugi::xml_document parse_xml(const std::string& file, const std::string& text) {
  pugi::xml_document document;
  const pugi::xml_parse_result result = document.load_buffer(text.data(), text.size());
  if (!result) throw FileError(file, fmt::format("byte {}: {}", result.offset, result.description()));
  return document;
}

std::vector<std::int64_t> numbers_of(const std::string& list) {
  std::vector<std::int64_t> numbers;
  const char* at = list.data();
  const char* const end = at + list.size();
  for (std::int64_t number = 0; at < end; ++at) {
    const auto [stop, error] = std::from_chars(at, end, number);
    if (error != std::errc{}) return {};
    numbers.push_back(number);
    at = stop;
  }
  return numbers;
}

/// Reads the first Wang set of a tileset, if there is one.
void read_wang_set(const std::string& file, const pugi::xml_node& set, TiledTileset& tileset) {
  std::vector<std::string> colors;
  for (const pugi::xml_node& color : set.children("wangcolor")) {
    const std::string name = color.attribute("name").as_string();
    colors.push_back(name.empty() ? fmt::format("colour {}", colors.size() + 1) : name);
  }
  for (const pugi::xml_node& tile : set.children("wangtile")) {
    tileset.wang[tile.attribute("tileid").as_uint()] =
        wang_colors(file, numbers_of(tile.attribute("wangid").as_string()), colors);
  }
}

TiledProperties properties_of(const std::string& file, const pugi::xml_node& node) {
  const auto value = [&](const char* name) {
    return node.find_child_by_attribute("property", "name", name).attribute("value");
  };
  TiledProperties properties;
  properties.name = value("name").as_string();
  properties.asset = value("asset").as_string();
  properties.weight = checked_weight(file, value("weight").as_double(1));
  properties.rotates = value("rotate").as_bool(true);
  return properties;
}

TiledTileset tileset_of(const pugi::xml_node& node, const std::filesystem::path& file) {
  TiledTileset tileset;
  tileset.name = node.attribute("name").as_string();
  tileset.tile_width = node.attribute("tilewidth").as_int();
  tileset.tile_height = node.attribute("tileheight").as_int();
  tileset.columns = node.attribute("columns").as_int();
  tileset.spacing = node.attribute("spacing").as_int();
  tileset.margin = node.attribute("margin").as_int();
  if (const pugi::xml_node image = node.child("image")) {
    tileset.image = file_beside(file, image.attribute("source").as_string());
  }
  for (const pugi::xml_node& tile : node.children("tile")) {
    if (const pugi::xml_node properties = tile.child("properties"))
      tileset.properties[tile.attribute("id").as_uint()] = properties_of(file.string(), properties);
  }
  read_wang_set(file.string(), node.child("wangsets").child("wangset"), tileset);
  return tileset;
}

void read_data(const std::string& file, const pugi::xml_node& data, const pugi::xml_node& holder,
               const std::string& encoding, const std::string& compression, TiledLayers& layers) {
  const std::int64_t width = holder.attribute("width").as_llong(),
                     height = holder.attribute("height").as_llong();
  if (width < 1 || height < 1 || width > (1 << 20) || height > (1 << 20)) {
    throw FileError(file, fmt::format("a layer of {} x {} tiles cannot be", width, height));
  }
  const auto count = static_cast<std::size_t>(width * height);
  std::vector<std::uint32_t> gids;
  if (encoding.empty()) {
    for (const pugi::xml_node& tile : data.children("tile")) gids.push_back(tile.attribute("gid").as_uint());
  } else {
    gids = decode_gids(file, data.child_value(), encoding, compression, count);
  }
  layers.add(file, holder.attribute("x").as_llong(), holder.attribute("y").as_llong(), width, height, gids);
}

void read_pin_layers(const std::string& file, const pugi::xml_node& root, TiledMap& map) {
  const int width = root.attribute("tilewidth").as_int(), height = root.attribute("tileheight").as_int();
  for (const pugi::xml_node& group : root.children("objectgroup")) {
    if (group.attribute("name").as_string() != std::string("pins")) continue;
    for (const pugi::xml_node& object : group.children("object")) {
      map.pins.push_back(pin_of(file,
                                {object.attribute("name").as_string(), object.attribute("x").as_double(),
                                 object.attribute("y").as_double(), object.attribute("width").as_double(),
                                 object.attribute("height").as_double()},
                                width, height));
    }
  }
}

}  // namespace

TiledTileset read_tsx(const std::filesystem::path& path) {
  const pugi::xml_document document = parse_xml(path.string(), read_bytes(path));
  const pugi::xml_node node = document.child("tileset");
  if (!node) throw FileError(path.string(), "is no tileset of Tiled");
  return tileset_of(node, path);
}

TiledMap read_tmx(const std::filesystem::path& path, const std::string& bytes, bool with_tilesets) {
  const std::string file = path.string();
  const pugi::xml_document document = parse_xml(file, bytes);
  const pugi::xml_node root = document.child("map");
  if (!root) throw FileError(file, "is no map of Tiled");
  const std::string orientation = root.attribute("orientation").as_string("orthogonal");
  if (orientation != "orthogonal")
    throw FileError(file, fmt::format("{} maps are not read, orthogonal ones are", orientation));
  TiledMap map;
  for (const pugi::xml_node& node : root.children("tileset")) {
    if (!with_tilesets) break;
    const std::string source = node.attribute("source").as_string();
    map.tilesets.push_back(source.empty() ? tileset_of(node, path) : read_tileset(file_beside(path, source)));
    map.tilesets.back().first_gid = node.attribute("firstgid").as_uint();
  }
  TiledLayers layers;
  for (const pugi::xml_node& node : root.children("layer")) {
    if (!node.attribute("visible").as_bool(true)) continue;
    layers.begin(file);
    const pugi::xml_node data = node.child("data");
    const std::string encoding = data.attribute("encoding").as_string();
    const std::string compression = data.attribute("compression").as_string();
    if (!data.child("chunk")) {
      read_data(file, data, node, encoding, compression, layers);
    }
    for (const pugi::xml_node& chunk : data.children("chunk")) {
      read_data(file, chunk, chunk, encoding, compression, layers);
    }
  }
  layers.write_to(file, map);
  read_pin_layers(file, root, map);
  return map;
}

}  // namespace solitaire::tiles
