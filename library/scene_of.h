#pragma once
#include <solitaire/solution.h>
#include <string>

#include "scene/scene.h"

namespace solitaire::api {

/// Returns the scene that a solution shows. Things that a broken assert is about are red all over, and carry
/// it as an extra, "broken": one of the choices on which the assert depends decides about the thing. In the
/// same way things carry the unmet wishes that are about them, "unmet". Throws SceneError.
Scene scene_of(const Solution& solution, const std::string& title, AssetLibrary& assets);

}  // namespace solitaire::api
