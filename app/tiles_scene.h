#pragma once
#include <string>

#include "engines/tiles/job/job.h"
#include "scene/assets.h"
#include "scene/scene.h"

namespace solitaire::app {

/// Returns the map that a job delivers as a scene: a metre a tile, each a model, or a box of its colour.
/// The scene refers to the models of `assets`.
Scene tiles_scene(const tiles::Job& job, const std::string& title, AssetLibrary& assets);

}  // namespace solitaire::app
