#pragma once
#include <cstddef>
#include <vector>

#include "scene/scene.h"

namespace solitaire {

/// A storey of a scene: what stands between one floor and the next. All indices are of Scene::objects.
struct Level {
  double floor = 0;                   // metres: where the lowest thing of it begins
  std::vector<std::size_t> standing;  // what one sees who looks down from head height
  std::vector<std::size_t> overhead;  // what hangs above something of the level: a roof, a lamp
};

/// Returns the levels from the lowest up. A level above the lowest begins with a floor: something thin and
/// large, at least a man's height above the floor before, on which something stands. A scene without objects
/// has none.
std::vector<Level> levels_of(const Scene& scene);

}  // namespace solitaire
