#pragma once
#include <string>
#include <vector>

#include "scene/scene.h"

namespace solitaire {

/// Builds the scene of these things, where `unit` is the length of one program unit in metres. Throws
/// SceneError for an asset that cannot be used, and for a size or place that is not finite or beyond 10,000
/// km; the text names the place call.
Scene build_scene(std::vector<PlacedThing> things, double unit, const std::string& title,
                  AssetLibrary& assets);

}  // namespace solitaire
