#pragma once
#include "scene/geometry.h"

namespace solitaire {

/// Returns the unit vector from a scene to the sun that lights it, in glTF's axes: at the right and high.
inline Vec3 to_sun() { return {0.666737, 0.724714, 0.173931}; }

}  // namespace solitaire
