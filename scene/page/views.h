#pragma once
#include <vector>

#include "scene/page/view.h"
#include "scene/scene.h"

namespace solitaire {

/// Returns the drawings of a scene that the page shows beside its model, none of a scene without objects.
std::vector<View> views_of(const Scene& scene);

}  // namespace solitaire
