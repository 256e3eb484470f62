#pragma once
#include <array>
#include <vector>

#include "scene/geometry.h"

namespace solitaire {

/// A polygon on the ground without holes, counter-clockwise seen from above: x right, y into the depth.
using Outline = std::vector<std::array<double, 2>>;

/// Returns why these points are no outline: too few, an edge that crosses or touches another, no area.
/// Returns
/// "" if they are one, in either direction.
const char* fault_of(const Outline& points);

/// Returns the outline counter-clockwise, moved and scaled so that it fills the square from -0.5 to 0.5.
Outline in_unit_square(Outline points);

/// Returns the faces of the body that stands on such an outline and fills the unit box (see unit_box): of its
/// top and its bottom triangles, of its sides rectangles, in glTF's axes, each counter-clockwise from
/// outside.
std::vector<std::vector<Vec3>> faces_over(const Outline& outline);

}  // namespace solitaire
