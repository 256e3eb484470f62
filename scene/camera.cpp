#include "scene/camera.h"

#include <algorithm>
#include <cmath>

namespace solitaire {
namespace {

constexpr double kHalfHeight = 0.26;  // of the view at a distance of 1: a little less than 30 degrees in all
constexpr double kMargin = 1.06;

double dot(const Vec3& a, const Vec3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vec3 normalized(const Vec3& v) {
  const double length = std::sqrt(dot(v, v));
  return {v[0] / length, v[1] / length, v[2] / length};
}

/// What the view must hold along one axis of the picture: the points lie between the lines through `low` and
/// `high` that open with the view. Coordinates are those of the camera's axes with the eye at the origin.
struct Extent {
  double low = Box3::kInfinity, high = -Box3::kInfinity;

  void include(double across, double ahead, double slope) {
    low = std::min(low, across + slope * ahead);
    high = std::max(high, across - slope * ahead);
  }
  double middle() const { return (low + high) / 2; }
  /// Returns how far the eye must go back until the view holds everything.
  double distance(double slope) const { return (high - low) / (2 * slope); }
};

std::vector<Vec3> corners_of(const Scene& scene) {
  std::vector<Vec3> corners;
  corners.reserve(8 * scene.objects.size());
  for (const SceneObject& object : scene.objects) {
    const Affine map = to_affine(object.node_transform);
    const Box3 box = object.asset ? object.asset->box : unit_box();
    for (int index = 0; index < 8; ++index) corners.push_back(map.apply(box.corner(index)));
  }
  return corners;
}

}  // namespace

Vec3 three_quarter_view() { return normalized({0.62, 1.0, 1.1}); }

Camera fitted_camera(const std::vector<Vec3>& points, const Vec3& to_camera, double aspect) {
  if (points.empty()) return fitted_camera({{-0.5, 0, -0.5}, {0.5, 1, 0.5}}, to_camera, aspect);
  Camera camera;
  camera.aspect = aspect;
  camera.half_height = kHalfHeight;
  camera.forward = {-to_camera[0], -to_camera[1], -to_camera[2]};
  camera.right = normalized(cross(camera.forward, {0, 1, 0}));
  camera.up = cross(camera.right, camera.forward);

  const double slope_up = kHalfHeight / kMargin, slope_right = slope_up * aspect;
  Extent right, up;
  double nearest = Box3::kInfinity, farthest = -Box3::kInfinity;
  for (const Vec3& point : points) {
    const double ahead = dot(point, camera.forward);
    right.include(dot(point, camera.right), ahead, slope_right);
    up.include(dot(point, camera.up), ahead, slope_up);
    nearest = std::min(nearest, ahead);
    farthest = std::max(farthest, ahead);
  }
  const double back = std::max(right.distance(slope_right), up.distance(slope_up));
  // A scene without any extent would leave the eye within it.
  const double ahead = std::min(-back, nearest - 1e-3);
  camera.nearest = nearest - ahead;
  camera.farthest = farthest - ahead;
  for (int axis = 0; axis < 3; ++axis) {
    camera.position[axis] =
        right.middle() * camera.right[axis] + up.middle() * camera.up[axis] + ahead * camera.forward[axis];
  }
  return camera;
}

Camera default_camera(const Scene& scene, double aspect) {
  return fitted_camera(corners_of(scene), three_quarter_view(), aspect);
}

}  // namespace solitaire
