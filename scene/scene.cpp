#include "scene/scene.h"

#include <cmath>
#include <numbers>

#include "scene/text.h"

namespace solitaire {

Box3 unit_box() { return {{-0.5, 0, -0.5}, {0.5, 1, 0.5}}; }

Box3 bounds(const PlacedBox& box) {
  const double angle = box.angle * std::numbers::pi / 180;
  const double c = std::abs(std::cos(angle)), s = std::abs(std::sin(angle));
  const double x = (c * box.size[0] + s * box.size[1]) / 2, y = (s * box.size[0] + c * box.size[1]) / 2;
  return {{box.center[0] - x, box.center[1] - y, box.center[2]},
          {box.center[0] + x, box.center[1] + y, box.top()}};
}

bool is_wall(const SceneObject& object) {
  if (object.asset) return object.asset->role == Asset::Role::kWall;
  return has_word(object.thing.name, "wall") || has_word(object.thing.asset, "wall");
}

std::string plain_name(const SceneObject& object) {
  if (!object.thing.name.empty()) return object.thing.name;
  if (object.asset) return object.asset->name;
  return object.thing.asset.empty() ? "box" : object.thing.asset;
}

}  // namespace solitaire
