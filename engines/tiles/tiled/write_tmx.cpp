#include <pugixml.hpp>
#include <sstream>
#include <vector>

#include "base/file_error.h"
#include "engines/tiles/read/file.h"
#include "engines/tiles/tiled/tileset_files.h"
#include "engines/tiles/tiled/write_tiled.h"

namespace solitaire::tiles {
namespace {

namespace fs = std::filesystem;

void rename_source(pugi::xml_attribute source, const fs::path& original, const fs::path& folder) {
  if (source) source.set_value(moved_name(source.as_string(), original, folder).c_str());
}

void set(pugi::xml_node node, const char* name, int value) {
  if (!node.attribute(name)) node.append_attribute(name);
  node.attribute(name).set_value(value);
}

std::string csv(const Grid& map, const Tileset& tileset, std::size_t layer) {
  std::string text = "\n";
  for (std::size_t site = 0; site < map.tiles.size(); ++site) {
    text += std::to_string(gid_in_layer(tileset, map[site], layer));
    if (site + 1 < map.tiles.size()) text += ',';
    if ((site + 1) % static_cast<std::size_t>(map.size.width()) == 0) text += '\n';
  }
  return text;
}

/// Takes all layers away but those of tiles that are visible, and returns these.
std::vector<pugi::xml_node> visible_layers(pugi::xml_node root) {
  std::vector<pugi::xml_node> kept;
  for (pugi::xml_node child = root.first_child(); child;) {
    const pugi::xml_node next = child.next_sibling();
    const std::string name = child.name();
    const bool visible = name == "layer" && child.attribute("visible").as_bool(true);
    if (visible) {
      kept.push_back(child);
    } else if (name == "layer" || name == "objectgroup" || name == "imagelayer" || name == "group") {
      root.remove_child(child);
    }
    child = next;
  }
  return kept;
}

void set_size(pugi::xml_node node, const Size& size) {
  set(node, "width", size.width());
  set(node, "height", size.height());
}

void set_data(pugi::xml_node layer, const Grid& map, const std::string& csv) {
  set_size(layer, map.size);
  layer.remove_child("data");
  pugi::xml_node data = layer.append_child("data");
  data.append_attribute("encoding").set_value("csv");
  data.text().set(csv.c_str());
}

void attribute(pugi::xml_node node, const char* name, const std::string& value) {
  node.append_attribute(name).set_value(value.c_str());
}

/// Makes an empty map with a tileset alone.
void make_map_around(const fs::path& file, pugi::xml_document& document) {
  const TiledTileset tileset = read_tileset(file);
  pugi::xml_node root = document.append_child("map");
  attribute(root, "version", "1.10");
  attribute(root, "orientation", "orthogonal");
  attribute(root, "renderorder", "right-down");
  set(root, "tilewidth", tileset.tile_width);
  set(root, "tileheight", tileset.tile_height);
  pugi::xml_node used = root.append_child("tileset");
  attribute(used, "firstgid", "1");
  attribute(used, "source", file.filename().string());
  pugi::xml_node layer = root.append_child("layer");
  attribute(layer, "id", "1");
  attribute(layer, "name", "tiles");
}

void load_pattern(const fs::path& original, pugi::xml_document& document) {
  if (is_tileset(original)) return make_map_around(original, document);
  const std::string bytes = read_bytes(original);
  if (!document.load_buffer(bytes.data(), bytes.size())) throw FileError(original.string(), "has changed");
}

}  // namespace

std::uint32_t gid_in_layer(const Tileset& tileset, Tile tile, std::size_t layer) {
  if (tile == kHole) return 0;
  const TileKind& kind = tileset[tile];
  if (layer < kind.parts.size()) return kind.parts[layer].gid;
  return layer == 0 ? kind.gid.value_or(0) : 0;
}

std::string moved_name(const std::string& name, const fs::path& original, const fs::path& folder) {
  const fs::path from = fs::absolute(original.parent_path() / name).lexically_normal();
  return from.lexically_relative(fs::absolute(folder).lexically_normal()).generic_string();
}

std::string write_tmx(const Grid& map, const Tileset& tileset, const fs::path& original,
                      const fs::path& folder) {
  pugi::xml_document document;
  load_pattern(original, document);
  const pugi::xml_node root = document.child("map");
  const std::vector<pugi::xml_node> layers = visible_layers(root);
  if (layers.empty()) throw FileError(original.string(), "has changed");
  for (pugi::xml_node node : root.children("tileset")) {
    rename_source(node.attribute("source"), original, folder);
    rename_source(node.child("image").attribute("source"), original, folder);
  }
  set_size(root, map.size);
  set(root, "infinite", 0);
  for (std::size_t number = 0; number < layers.size(); ++number)
    set_data(layers[number], map, csv(map, tileset, number));
  std::ostringstream text;
  document.save(text, " ");
  return text.str();
}

}  // namespace solitaire::tiles
