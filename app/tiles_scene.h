#pragma once
#include <string>
#include <vector>

#include "engines/tiles/job/job.h"
#include "scene/assets.h"
#include "scene/scene.h"

namespace solitaire::app {

/// Returns the tiles of a map as a scene: a metre a tile, each a model, the cubes of its voxels or a box of
/// its colour. The scene refers to the models of `assets`.
Scene tiles_scene(const std::vector<tiles::ShownTile>& tiles, const std::string& title, AssetLibrary& assets);

}  // namespace solitaire::app
