#pragma once
#include <vector>

#include "scene/geometry.h"
#include "scene/opening.h"
#include "scene/scene.h"

namespace solitaire {

/// Puts an opening into each wall for each door and window that stands in it: a thing in the same direction
/// whose box goes through at least half of the wall's thickness. A wall of which an end, the top or all would
/// be left out stays as it is.
void make_openings(Scene& scene);

/// Returns the blocks that make up a box with these openings. Blocks touch and do not overlap.
std::vector<Box3> solid_parts(const Box3& box, const std::vector<Opening>& openings);

}  // namespace solitaire
