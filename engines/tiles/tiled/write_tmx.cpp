#include <pugixml.hpp>
#include <sstream>

#include "base/file_error.h"
#include "engines/tiles/read/file.h"
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

std::string csv(const Grid& map, const Tileset& tileset) {
  std::string text = "\n";
  for (std::size_t site = 0; site < map.tiles.size(); ++site) {
    const Tile tile = map[site];
    text += std::to_string(tile == kHole ? 0 : tileset[tile].gid.value_or(0));
    if (site + 1 < map.tiles.size()) text += ',';
    if ((site + 1) % static_cast<std::size_t>(map.size.width()) == 0) text += '\n';
  }
  return text;
}

/// Takes all layers away but the first that is visible, and returns that.
pugi::xml_node only_layer(pugi::xml_node root) {
  pugi::xml_node kept;
  for (pugi::xml_node child = root.first_child(); child;) {
    const pugi::xml_node next = child.next_sibling();
    const std::string name = child.name();
    const bool visible = name == "layer" && child.attribute("visible").as_bool(true);
    if (visible && !kept) {
      kept = child;
    } else if (name == "layer" || name == "objectgroup" || name == "imagelayer" || name == "group") {
      root.remove_child(child);
    }
    child = next;
  }
  return kept;
}

}  // namespace

std::string moved_name(const std::string& name, const fs::path& original, const fs::path& folder) {
  const fs::path from = fs::absolute(original.parent_path() / name).lexically_normal();
  return from.lexically_relative(fs::absolute(folder).lexically_normal()).generic_string();
}

std::string write_tmx(const Grid& map, const Tileset& tileset, const fs::path& original,
                      const fs::path& folder) {
  pugi::xml_document document;
  const std::string bytes = read_bytes(original);
  if (!document.load_buffer(bytes.data(), bytes.size())) throw FileError(original.string(), "has changed");
  const pugi::xml_node root = document.child("map");
  pugi::xml_node layer = only_layer(root);
  if (!layer) throw FileError(original.string(), "has changed");
  for (pugi::xml_node node : root.children("tileset")) {
    rename_source(node.attribute("source"), original, folder);
    rename_source(node.child("image").attribute("source"), original, folder);
  }
  for (pugi::xml_node node : {root, layer}) {
    set(node, "width", map.size.width());
    set(node, "height", map.size.height());
  }
  set(root, "infinite", 0);
  layer.remove_child("data");
  pugi::xml_node data = layer.append_child("data");
  data.append_attribute("encoding").set_value("csv");
  data.text().set(csv(map, tileset).c_str());
  std::ostringstream text;
  document.save(text, " ");
  return text.str();
}

}  // namespace solitaire::tiles
