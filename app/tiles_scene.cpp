#include "app/tiles_scene.h"

#include <fmt/format.h>

#include "scene/build_scene.h"
#include "scene/voxel_asset.h"

namespace solitaire::app {
namespace {

Asset asset_of(const std::string& name, const tiles::ShownModel& model) {
  std::vector<Voxel> voxels;
  for (const tiles::ShownVoxel& voxel : model.voxels) voxels.push_back({voxel.at, voxel.color});
  return voxel_asset(name, voxels, 1.0 / model.across);
}

/// Says that a thing is the cubes of its tile's model, which need not reach to all sides of the tile.
void set_voxels(const tiles::ShownTile& tile, PlacedThing& thing, AssetLibrary& assets) {
  const tiles::ShownModel& model = *tile.model;
  const Asset& asset = assets.made(tile.name + ".vox", [&] { return asset_of(tile.name + ".vox", model); });
  thing.asset = asset.name;
  thing.at[0] += asset.box.low[0];
  thing.at[1] -= asset.box.high[2];
  thing.at[2] = thing.at[2] * model.layers / model.across + asset.box.low[1];
}

PlacedThing thing_of(const tiles::ShownTile& tile, AssetLibrary& assets) {
  PlacedThing thing;
  const auto [x, y, z] = tile.at;
  thing.asset = tile.asset;
  thing.at = {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
  thing.name = tile.name;
  thing.address = fmt::format("site[{}][{}][{}]", z, y, x);
  if (!tile.asset.empty()) {
    thing.turn = tile.turn;
  } else if (tile.model) {
    set_voxels(tile, thing, assets);
  } else {
    thing.size = {1, 1, tile.height};
    thing.color = tile.color;
  }
  return thing;
}

}  // namespace

Scene tiles_scene(const std::vector<tiles::ShownTile>& tiles, const std::string& title,
                  AssetLibrary& assets) {
  std::vector<PlacedThing> things;
  for (const tiles::ShownTile& tile : tiles) things.push_back(thing_of(tile, assets));
  return build_scene(things, 1.0, title, assets);
}

}  // namespace solitaire::app
