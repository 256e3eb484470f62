#pragma once
#include <filesystem>
#include <string>

#include "engines/tiles/job/job.h"
#include "scene/scene.h"

namespace solitaire::app {

/// Returns the map that a job delivers as a scene: a metre a tile, each a model, or a box of its colour.
/// Models are found as in programs: bundled ones by their names, others relative to `folder`.
Scene tiles_scene(const tiles::Job& job, const std::string& title, const std::filesystem::path& folder);

}  // namespace solitaire::app
