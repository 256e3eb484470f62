#include "scene/picture/cutaway.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "scene/text.h"

namespace solitaire {
namespace {

constexpr double kCutHeight = 0.3;        // metres that are left of a wall
constexpr double kTableHeight = 0.8;      // metres that are left of what stands at a wall that is cut
constexpr double kTallest = 1.2;          // metres, of what stands there whole
constexpr double kAtWall = 0.15;          // metres between a wall and what stands at it
constexpr double kFooting = 0.05;         // metres between a thing and what it stands on
constexpr double kLowestWall = 1.0;       // metres; what is lower hides little
constexpr double kThickestWall = 0.6;     // metres, of plain boxes
constexpr double kOverlap = 0.25;         // metres of a thing that a wall may hide or stand on
constexpr double kWidestOnTop = 2;        // times as wide as the wall is what goes with it, standing on it
constexpr std::size_t kMostAsked = 2000;  // things that are asked what they stand on
constexpr std::size_t kMostWallPairs = 20'000'000;

bool says(const SceneObject& object, std::string_view word) {
  return has_word(object.thing.asset, word) || has_word(object.thing.name, word);
}

/// An interval of how far along a direction something lies, in multiples of the direction.
struct Reach {
  double from = 0, to = 1;

  /// Keeps the part in which low <= at + step * t <= high.
  void limit(double low, double high, double at, double step) {
    if (step == 0) {
      if (at < low || at > high) to = -1;
      return;
    }
    const double a = (low - at) / step, b = (high - at) / step;
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
  }
};

/// The things that a wall could hide, a little smaller than they are.
Box3 core(const PlacedBox& box) {
  Box3 core = bounds(box);
  for (int axis = 0; axis < 2; ++axis) {
    const double by = std::min(kOverlap, (core.high[axis] - core.low[axis]) / 2);
    core.low[axis] += by;
    core.high[axis] -= by;
  }
  return core;
}

/// Returns true if the wall, which hides what lies behind it as far as `shadow` reaches, hides a part of
/// `thing`.
bool hides(const Box3& wall, const Box3& thing, const std::array<double, 2>& shadow) {
  Reach reach;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    reach.limit(thing.low[axis] - (wall.high[axis] - wall.low[axis]), thing.high[axis], wall.low[axis],
                shadow[axis]);
  }
  return reach.from <= reach.to && thing.low[2] < wall.high[2];
}

bool is_within(const Vec3& point, const Box3& box) {
  return point[0] > box.low[0] && point[0] < box.high[0] && point[1] > box.low[1] && point[1] < box.high[1] &&
         point[2] < box.high[2];
}

/// Returns true for what is at one of the wall's sides.
bool is_at(const Box3& thing, const Box3& wall) {
  const std::size_t across = wall.high[0] - wall.low[0] < wall.high[1] - wall.low[1] ? 0 : 1;
  const std::size_t along = 1 - across;
  const double gap = std::max(wall.low[across] - thing.high[across], thing.low[across] - wall.high[across]);
  const double middle = (thing.low[along] + thing.high[along]) / 2;
  return gap < kAtWall && wall.low[along] < middle && middle < wall.high[along];
}

/// Returns true for what stands on the same floor as the wall, at one of its sides, and is tall.
bool towers_at(const Box3& thing, const Box3& wall) {
  return thing.low[2] <= wall.low[2] + kCutHeight && thing.high[2] - wall.low[2] >= kTallest &&
         is_at(thing, wall);
}

/// Returns true if the thing stands on `below`.
bool stands_on(const Box3& thing, const Box3& below) {
  const Vec3 middle{(thing.low[0] + thing.high[0]) / 2, (thing.low[1] + thing.high[1]) / 2, below.low[2]};
  return is_within(middle, below) && std::abs(thing.low[2] - below.high[2]) < kFooting;
}

/// Returns true for what is in a wall, or stands on it and is not much wider, as a tower's roof does and a
/// floor does not.
bool belongs_to(const PlacedBox& thing, const Box3& wall) {
  if (is_within(thing.center, wall)) return true;
  const Box3 box = bounds(thing);
  return stands_on(box, wall) && box.size()[0] < kWidestOnTop * wall.size()[0] &&
         box.size()[1] < kWidestOnTop * wall.size()[1];
}

/// Finds the walls to cut, and what is cut with them.
class Cutaway {
 public:
  Cutaway(const Scene& scene, const Vec3& to_camera) : scene_(scene), to_camera_(to_camera) {
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
      if (is_like_wall(scene.objects[i])) walls_.push_back({i, bounds(scene.objects[i].box), {}});
    }
  }

  std::vector<std::optional<double>> heights() {
    std::vector<std::optional<double>> heights(scene_.objects.size());
    if (to_camera_[1] <= 0 || walls_.size() * scene_.objects.size() > kMostWallPairs) return heights;
    sort_others();
    for (const Wall& wall : walls_) {
      if (!hides_something(wall.box)) continue;
      const double foot = wall.box.low[2];
      heights[wall.object] = foot + kCutHeight;
      for (const std::size_t fixture : wall.fixtures) heights[fixture] = foot + kCutHeight;
      for (const std::size_t other : others_) {
        if (heights[other]) continue;
        const Box3 box = bounds(scene_.objects[other].box);
        if (towers_at(box, wall.box)) heights[other] = foot + kTableHeight;
        if (hangs_at(box, wall.box)) heights[other] = foot + kCutHeight;
      }
    }
    return heights;
  }

 private:
  struct Wall {
    std::size_t object;
    Box3 box;
    std::vector<std::size_t> fixtures;  // the objects in it that go with it
  };

  /// Tells what is in a wall from what a wall may hide.
  void sort_others() {
    std::size_t next_wall = 0;
    for (std::size_t i = 0; i < scene_.objects.size(); ++i) {
      if (next_wall < walls_.size() && walls_[next_wall].object == i) {
        ++next_wall;
        continue;
      }
      const SceneObject& object = scene_.objects[i];
      const auto around = std::find_if(walls_.begin(), walls_.end(),
                                       [&](const Wall& wall) { return belongs_to(object.box, wall.box); });
      if (around == walls_.end()) {
        hidden_.push_back(core(object.box));
        others_.push_back(i);
      } else {
        around->fixtures.push_back(i);
      }
    }
  }

  /// Returns true for what is at the wall above what is left of it, and stands on nothing.
  bool hangs_at(const Box3& thing, const Box3& wall) const {
    if (others_.size() > kMostAsked) return false;
    if (thing.low[2] <= wall.low[2] + kCutHeight || thing.low[2] >= wall.high[2] || !is_at(thing, wall))
      return false;
    return std::none_of(others_.begin(), others_.end(), [&](std::size_t other) {
      return stands_on(thing, bounds(scene_.objects[other].box));
    });
  }

  bool hides_something(const Box3& wall) const {
    // glTF's z runs against the program's y.
    const double length = (wall.high[2] - wall.low[2]) / to_camera_[1];
    const std::array<double, 2> shadow{-to_camera_[0] * length, to_camera_[2] * length};
    return std::any_of(hidden_.begin(), hidden_.end(),
                       [&](const Box3& thing) { return hides(wall, thing, shadow); });
  }

  const Scene& scene_;
  Vec3 to_camera_;
  std::vector<Wall> walls_;          // in the order of their objects
  std::vector<Box3> hidden_;         // the cores of what a wall may hide
  std::vector<std::size_t> others_;  // the objects that they are of
};

}  // namespace

bool is_like_wall(const SceneObject& object) {
  const Vec3& size = object.box.size;
  if (size[2] < kLowestWall) return false;
  if (is_wall(object) || says(object, "wall")) return true;
  const double thick = std::min(size[0], size[1]), wide = std::max(size[0], size[1]);
  return object.thing.asset.empty() && thick <= kThickestWall && wide >= 3 * thick;
}

std::vector<std::optional<double>> cut_heights(const Scene& scene, const Vec3& to_camera) {
  return Cutaway(scene, to_camera).heights();
}

}  // namespace solitaire
