#pragma once
#include <vector>

#include "scene/page/drawing/view.h"
#include "scene/scene.h"

namespace solitaire {

/// Returns the drawings of a scene that the page shows beside its model, none of a scene without objects, or
/// with more than five thousand.
std::vector<View> views_of(const Scene& scene);

}  // namespace solitaire
