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
    const pugi::xml_node name = tile.child("properties").find_child_by_attribute("property", "name", "name");
    if (name) tileset.names[tile.attribute("id").as_uint()] = name.attribute("value").as_string();
  }
  return tileset;
}

void read_data(const std::string& file, const pugi::xml_node& data, const pugi::xml_node& holder,
               const std::string& encoding, const std::string& compression, TiledLayer& layer) {
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
  layer.add(file, holder.attribute("x").as_llong(), holder.attribute("y").as_llong(), width, height, gids);
}

}  // namespace

TiledTileset read_tsx(const std::filesystem::path& path) {
  const pugi::xml_document document = parse_xml(path.string(), read_bytes(path));
  const pugi::xml_node node = document.child("tileset");
  if (!node) throw FileError(path.string(), "is no tileset of Tiled");
  return tileset_of(node, path);
}

TiledMap read_tmx(const std::filesystem::path& path, const std::string& bytes) {
  const std::string file = path.string();
  const pugi::xml_document document = parse_xml(file, bytes);
  const pugi::xml_node root = document.child("map");
  if (!root) throw FileError(file, "is no map of Tiled");
  const std::string orientation = root.attribute("orientation").as_string("orthogonal");
  if (orientation != "orthogonal")
    throw FileError(file, fmt::format("{} maps are not read, orthogonal ones are", orientation));
  TiledMap map;
  for (const pugi::xml_node& node : root.children("tileset")) {
    const std::string source = node.attribute("source").as_string();
    map.tilesets.push_back(source.empty() ? tileset_of(node, path) : read_tileset(file_beside(path, source)));
    map.tilesets.back().first_gid = node.attribute("firstgid").as_uint();
  }
  TiledLayer layer;
  int layers = 0;
  for (const pugi::xml_node& node : root.children("layer")) {
    if (!node.attribute("visible").as_bool(true)) continue;
    if (++layers > 1) throw FileError(file, "has several visible layers; hide all but one");
    const pugi::xml_node data = node.child("data");
    const std::string encoding = data.attribute("encoding").as_string();
    const std::string compression = data.attribute("compression").as_string();
    if (!data.child("chunk")) {
      read_data(file, data, node, encoding, compression, layer);
    }
    for (const pugi::xml_node& chunk : data.children("chunk")) {
      read_data(file, chunk, chunk, encoding, compression, layer);
    }
  }
  layer.write_to(file, map);
  return map;
}

}  // namespace solitaire::tiles
