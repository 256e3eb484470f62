#pragma once
#include <filesystem>
#include <string>

#include "engines/tiles/job/job.h"

namespace solitaire::app {

/// Writes the map that a job delivers as a scene (.glb): a metre a tile, each a model, or a box of its
/// colour. Models are found as in programs: bundled ones by their names, others relative to `folder`.
void write_tiles_scene(const tiles::Job& job, const std::string& title, const std::filesystem::path& folder,
                       const std::filesystem::path& file);

}  // namespace solitaire::app
