#include "app/tiles_scene.h"

#include <fmt/format.h>

#include "scene/build_scene.h"

namespace solitaire::app {
namespace {

PlacedThing thing_of(const tiles::ShownTile& tile) {
  PlacedThing thing;
  const auto [x, y, z] = tile.at;
  thing.asset = tile.asset;
  thing.at = {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
  thing.name = tile.name;
  thing.address = fmt::format("site[{}][{}][{}]", z, y, x);
  if (tile.asset.empty()) {
    thing.size = {1, 1, tile.height};
    thing.color = tile.color;
  } else {
    thing.turn = tile.turn;
  }
  return thing;
}

}  // namespace

Scene tiles_scene(const std::vector<tiles::ShownTile>& tiles, const std::string& title,
                  AssetLibrary& assets) {
  std::vector<PlacedThing> things;
  for (const tiles::ShownTile& tile : tiles) things.push_back(thing_of(tile));
  return build_scene(things, 1.0, title, assets);
}

}  // namespace solitaire::app
