#include "scene/picture/eye_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <numbers>
#include <vector>

#include "scene/picture/cutaway.h"

namespace solitaire {
namespace {

constexpr double kEyeHeight = 1.6;      // metres
constexpr double kFullSize = 4;         // metres: in a smaller scene stands somebody smaller
constexpr double kSurroundings = 0.35;  // of the scene's longer side: how far beside it one may stand
constexpr int kGrid = 20;               // are tried along each side
constexpr double kFree = 0.4;           // metres around one's feet
constexpr double kStep = 0.15;          // metres; one stands on what is no higher
constexpr double kNearest = 0.8;        // metres; what is nearer only hides things
constexpr double kHalfView = 0.6;       // of the view at a distance of 1: 62 degrees in all
constexpr double kDown = 0.12;          // how far one looks down at a distance of 1
constexpr int kColumns = 48;            // directions around a place
constexpr int kRows = 10;               // heights in each of them
constexpr double kWallWorth = 0.3;      // of a wall, beside that of anything else
constexpr std::size_t kUnseen = SIZE_MAX;

/// What is seen around a place: for each direction a column of objects.
using Panorama = std::vector<std::array<std::size_t, kRows>>;

Vec3 heading(double column) {
  const double angle = 2 * std::numbers::pi * column / kColumns;
  return {rounded(std::sin(angle), 9), 0, rounded(-std::cos(angle), 9)};
}

class EyeView {
 public:
  EyeView(const Scene& scene, const RayScene& traced, double aspect)
      : scene_(scene), traced_(traced), aspect_(aspect), box_(bounds(scene)) {
    const Vec3 size = box_.size();
    scale_ = std::min(1.0, std::max(size[0], size[1]) / kFullSize);
    for (const SceneObject& object : scene.objects) worth_.push_back(is_like_wall(object) ? kWallWorth : 1);
    reach_ = static_cast<int>(std::atan(kHalfView * aspect) / (2 * std::numbers::pi) * kColumns);
  }

  Camera best() {
    for (int i = 0; i <= kGrid; ++i) {
      for (int j = 0; j <= kGrid; ++j) try_place(i, j);
    }
    return camera_at(eye_, heading_);
  }

 private:
  /// Returns a place of the grid over the scene and its surroundings, along one of the program's axes.
  double grid(std::size_t axis, int step) const {
    const Vec3 size = box_.size();
    const double beside = kSurroundings * std::max(size[0], size[1]);
    return box_.low[axis] - beside + (size[axis] + 2 * beside) * step / kGrid;
  }

  void try_place(int i, int j) {
    const double x = grid(0, i), y = grid(1, j);
    const double floor = floor_at(x, y);
    if (!is_free(x, y, floor)) return;
    const Vec3 eye{x, floor + kEyeHeight * scale_, -y};
    const Panorama seen = look_around(eye);
    for (int column = 0; column < kColumns; ++column) {
      const double worth = worth_of(seen, column);
      if (worth <= best_worth_) continue;
      best_worth_ = worth;
      eye_ = eye;
      heading_ = column;
    }
  }

  Ray ray(const Vec3& from, const Vec3& direction) const {
    const Vec3& middle = traced_.middle();
    return {to_vector({from[0] - middle[0], from[1] - middle[1], from[2] - middle[2]}),
            normalized(to_vector(direction))};
  }

  /// Returns the height of what is below somebody who would stand on the ground.
  double floor_at(double x, double y) const {
    const double eye = box_.low[2] + kEyeHeight * scale_;
    const auto hit = traced_.trace(ray({x, eye, -y}, {0, -1, 0}));
    return hit ? eye - static_cast<double>(hit->distance) : box_.low[2];
  }

  bool is_free(double x, double y, double floor) const {
    const double room = kFree * scale_;
    return std::none_of(scene_.objects.begin(), scene_.objects.end(), [&](const SceneObject& object) {
      const Box3 box = bounds(object.box);
      return box.low[2] < floor + kEyeHeight * scale_ && box.high[2] > floor + kStep * scale_ &&
             box.low[0] < x + room && box.high[0] > x - room && box.low[1] < y + room &&
             box.high[1] > y - room;
    });
  }

  Panorama look_around(const Vec3& eye) const {
    Panorama seen(kColumns);
    for (int column = 0; column < kColumns; ++column) {
      for (int row = 0; row < kRows; ++row) {
        Vec3 direction = heading(column);
        direction[1] = kHalfView * ((2 * row + 1.0) / kRows - 1) - kDown;
        const auto hit = traced_.trace(ray(eye, direction));
        const bool is_seen = hit && static_cast<double>(hit->distance) > kNearest * scale_;
        seen[static_cast<std::size_t>(column)][static_cast<std::size_t>(row)] =
            is_seen ? hit->object : kUnseen;
      }
    }
    return seen;
  }

  /// Returns how much is seen in a direction: many things, and each large, though more of one is worth less.
  double worth_of(const Panorama& seen, int column) const {
    std::vector<std::size_t> objects;
    for (int i = column - reach_; i <= column + reach_; ++i) {
      const auto& there = seen[static_cast<std::size_t>((i + kColumns) % kColumns)];
      std::copy_if(there.begin(), there.end(), std::back_inserter(objects),
                   [](std::size_t object) { return object != kUnseen; });
    }
    std::sort(objects.begin(), objects.end());
    double worth = 0;
    for (auto first = objects.begin(); first != objects.end();) {
      const auto last = std::upper_bound(first, objects.end(), *first);
      worth += worth_[*first] * std::sqrt(static_cast<double>(last - first));
      first = last;
    }
    return worth;
  }

  Camera camera_at(const Vec3& eye, int column) const {
    const Vec3 ahead = heading(column);
    const double length = std::sqrt(1 + kDown * kDown);
    Camera camera;
    camera.position = eye;
    camera.forward = {ahead[0] / length, -kDown / length, ahead[2] / length};
    camera.right = {-ahead[2], 0, ahead[0]};
    camera.up = {ahead[0] * kDown / length, 1 / length, ahead[2] * kDown / length};
    camera.half_height = kHalfView;
    camera.aspect = aspect_;
    return camera;
  }

  const Scene& scene_;
  const RayScene& traced_;
  double aspect_;
  Box3 box_;                   // of the whole scene, along the program's axes
  double scale_ = 1;           // of somebody in this scene
  std::vector<double> worth_;  // of each object
  int reach_ = 0;              // columns that are seen at each side of the one that one looks at
  double best_worth_ = -1;
  Vec3 eye_{};
  int heading_ = 0;
};

}  // namespace

Camera eye_view(const Scene& scene, const RayScene& traced, double aspect) {
  if (scene.objects.empty()) return default_camera(scene, aspect);
  return EyeView(scene, traced, aspect).best();
}

}  // namespace solitaire
