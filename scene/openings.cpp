#include "scene/openings.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace solitaire {
namespace {

constexpr double kLeast = 1e-3;  // the share of a wall below which nothing is left out or left over

bool is_parallel(double degrees) { return std::abs(std::remainder(degrees, 90.0)) < 0.01; }

/// Returns the fixture's extent in the frame of the wall, whose left front foot is the origin, in shares of
/// the wall.
Box3 in_wall(const PlacedBox& fixture, const PlacedBox& wall) {
  const Vec3 apart{fixture.center[0] - wall.center[0], fixture.center[1] - wall.center[1],
                   fixture.center[2] - wall.center[2]};
  const Affine unturn = to_affine({{}, about_up(-wall.angle), {1, 1, 1}});
  const Vec3 center = unturn.apply({apart[0], apart[2], -apart[1]});  // in glTF's axes
  PlacedBox moved = fixture;
  moved.center = {center[0], -center[2], center[1]};
  moved.angle = fixture.angle - wall.angle;
  Box3 box = bounds(moved);
  for (int axis = 0; axis < 3; ++axis) {
    const double origin = axis == 2 ? 0 : -wall.size[axis] / 2;
    box.low[axis] = (box.low[axis] - origin) / wall.size[axis];
    box.high[axis] = (box.high[axis] - origin) / wall.size[axis];
  }
  return box;
}

std::optional<Opening> opening_for(const PlacedBox& fixture, const PlacedBox& wall) {
  if (!is_parallel(fixture.angle - wall.angle)) return std::nullopt;
  const Box3 box = in_wall(fixture, wall);
  const auto share = [&](int axis) { return std::min(box.high[axis], 1.0) - std::max(box.low[axis], 0.0); };
  if (share(0) < kLeast || share(1) < 0.5 || share(2) < kLeast) return std::nullopt;
  const auto within = [](double value) { return value < kLeast ? 0 : value > 1 - kLeast ? 1 : value; };
  return Opening{within(box.low[0]), within(box.high[0]), within(box.low[2]), within(box.high[2])};
}

/// Returns true if what is left of a wall still reaches to both of its ends and to its top.
bool keeps_extent(const std::vector<Opening>& openings) {
  Box3 left_over;
  for (const Box3& part : solid_parts({{0, 0, 0}, {1, 1, 1}}, openings)) {
    left_over.include(part.low);
    left_over.include(part.high);
  }
  return left_over.low == Vec3{0, 0, 0} && left_over.high == Vec3{1, 1, 1};
}

/// Returns where an interval is cut by the edges of openings, its own ends included.
std::vector<double> cuts(const std::vector<Opening>& openings, double Opening::*one, double Opening::*other) {
  std::vector<double> places = {0, 1};
  for (const Opening& opening : openings) {
    places.push_back(opening.*one);
    places.push_back(opening.*other);
  }
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

}  // namespace

void make_openings(Scene& scene) {
  std::vector<const SceneObject*> fixtures;
  for (const SceneObject& object : scene.objects) {
    if (object.asset && object.asset->role == Asset::Role::kOpening) fixtures.push_back(&object);
  }
  for (SceneObject& object : scene.objects) {
    if (!is_wall(object)) continue;
    for (const SceneObject* fixture : fixtures) {
      if (const auto opening = opening_for(fixture->box, object.box)) object.openings.push_back(*opening);
    }
    if (!keeps_extent(object.openings)) object.openings.clear();
  }
}

std::vector<Box3> solid_parts(const Box3& box, const std::vector<Opening>& openings) {
  const auto at = [&](int axis, double share) {
    return box.low[axis] + share * (box.high[axis] - box.low[axis]);
  };
  const std::vector<double> across = cuts(openings, &Opening::left, &Opening::right);
  const std::vector<double> up = cuts(openings, &Opening::low, &Opening::high);
  std::vector<Box3> parts;
  for (std::size_t i = 0; i + 1 < across.size(); ++i) {
    const double left = across[i], right = across[i + 1];
    const auto is_open = [&](double low) {
      return std::any_of(openings.begin(), openings.end(), [&](const Opening& opening) {
        return opening.left <= left && right <= opening.right && opening.low <= low && low < opening.high;
      });
    };
    for (std::size_t from = 0; from + 1 < up.size();) {
      std::size_t to = from;
      while (to + 1 < up.size() && !is_open(up[to])) ++to;
      if (to > from) {
        parts.push_back(
            {{at(0, left), at(1, up[from]), box.low[2]}, {at(0, right), at(1, up[to]), box.high[2]}});
      }
      from = to + 1;
    }
  }
  return parts;
}

}  // namespace solitaire
