#include "scene/scene.h"

#include <cmath>
#include <numbers>

#include "scene/text.h"

namespace solitaire {
namespace {

Box3 bounds_of_tilted(const PlacedBox& box) {
  const Affine map = to_affine({{box.center[0], box.center[2], -box.center[1]}, orientation(box), {1, 1, 1}});
  const Box3 turned = transformed(
      map, {{-box.size[0] / 2, 0, -box.size[1] / 2}, {box.size[0] / 2, box.size[2], box.size[1] / 2}});
  return {{turned.low[0], -turned.high[2], turned.low[1]}, {turned.high[0], -turned.low[2], turned.high[1]}};
}

}  // namespace

Box3 unit_box() { return {{-0.5, 0, -0.5}, {0.5, 1, 0.5}}; }

Quaternion orientation(const PlacedBox& box, double turn) {
  if (box.pitch == 0 && box.roll == 0) return about_up(box.angle + turn);
  const Quaternion tilt = after(about_axis(0, -box.pitch), about_axis(2, -box.roll));
  return after(about_up(box.angle), after(tilt, about_up(turn)));
}

Box3 bounds(const PlacedBox& box) {
  if (box.pitch != 0 || box.roll != 0) return bounds_of_tilted(box);
  const double angle = box.angle * std::numbers::pi / 180;
  const double c = std::abs(std::cos(angle)), s = std::abs(std::sin(angle));
  const double x = (c * box.size[0] + s * box.size[1]) / 2, y = (s * box.size[0] + c * box.size[1]) / 2;
  return {{box.center[0] - x, box.center[1] - y, box.center[2]},
          {box.center[0] + x, box.center[1] + y, box.top()}};
}

Box3 bounds(const Scene& scene) {
  Box3 all;
  for (const SceneObject& object : scene.objects) {
    const Box3 box = bounds(object.box);
    all.include(box.low);
    all.include(box.high);
  }
  return all;
}

bool has_own_mesh(const SceneObject& object) { return !object.openings.empty() || !object.outline.empty(); }

bool is_wall(const SceneObject& object) {
  if (!object.outline.empty()) return false;
  if (object.asset) return object.asset->role == Asset::Role::kWall;
  return has_word(object.thing.name, "wall") || has_word(object.thing.asset, "wall");
}

std::string plain_name(const SceneObject& object) {
  if (!object.thing.name.empty()) return object.thing.name;
  if (object.asset) return object.asset->name;
  return object.thing.asset.empty() ? "box" : object.thing.asset;
}

std::string text_on(const SceneObject& object) {
  return object.label.empty() ? plain_name(object) : object.label;
}

}  // namespace solitaire
