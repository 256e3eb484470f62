#include "engines/tiles/read/json.h"

#include <fmt/format.h>
#include <stdexcept>

#include "engines/tiles/model/palette.h"
#include "engines/tiles/read/json_object.h"

namespace solitaire::tiles {
namespace {

/// Returns the tileset's tile for each name in the file.
std::vector<Tile> tiles_named(JsonObject& file, Tileset& tileset, bool open) {
  std::vector<Tile> tiles;
  for (const std::string& name : file.texts("tiles")) {
    auto tile = tileset.find(name);
    if (!tile && !open) file.fail("tiles", fmt::format("has '{}', which is no tile of the tileset", name));
    if (!tile) {
      TileKind kind;
      kind.name = name;
      kind.color = palette_color(tileset.size());
      try {
        tile = tileset.add(std::move(kind));
      } catch (const std::length_error& error) {
        file.fail("tiles", error.what());
      }
    }
    tiles.push_back(*tile);
  }
  return tiles;
}

Size size_of(JsonObject& file) {
  const std::vector<int> numbers = file.numbers("size", 1, 2, 3);
  Size size;
  std::size_t sites = 1;
  for (std::size_t axis = 0; axis < numbers.size(); ++axis) {
    size.extent[axis] = numbers[axis];
    if (sites > kMostSites / static_cast<std::size_t>(numbers[axis])) file.fail("size", "is too large");
    sites *= static_cast<std::size_t>(numbers[axis]);
  }
  return size;
}

}  // namespace

Grid read_json(const std::string& name, const std::string& text, Tileset& tileset, bool open) {
  const nlohmann::json json = parse_json(name, text);
  JsonObject file(name, json, "");
  const Size size = size_of(file);
  const nlohmann::json& data = file.at("data");
  if (!data.is_array() || data.size() != size.volume()) {
    file.fail("data", fmt::format("is no list of {} numbers, as the size says", size.volume()));
  }
  const std::vector<Tile> tiles = tiles_named(file, tileset, open);
  Grid grid(size);
  for (std::size_t site = 0; site < data.size(); ++site) {
    const std::int64_t number = data[site].is_number_integer() ? data[site].get<std::int64_t>() : -2;
    if (number < -1 || number >= static_cast<std::int64_t>(tiles.size())) {
      file.fail("data", fmt::format("has an entry [{}] that is no number of a tile", site));
    }
    if (number >= 0) grid[site] = tiles[static_cast<std::size_t>(number)];
  }
  return grid;
}

}  // namespace solitaire::tiles
