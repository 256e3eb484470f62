#pragma once
#include <string>

#include "scene/scene.h"

namespace solitaire {

/// From where a scene is drawn without perspective.
enum class Side { kFront, kRight };

/// Returns the scene as it is seen from a side, as an <svg> element, with lines that say how high things are.
/// Walls that would hide something are outlined only. The scene must have objects.
std::string svg_elevation(const Scene& scene, Side side);

/// Returns the scene from its front, its right and above, with the same scale in all three directions, as an
/// <svg> element. Walls that would hide something are cut off low. The scene must have objects.
std::string svg_isometric(const Scene& scene);

}  // namespace solitaire
