#include "scene/page/drawing/levels.h"

#include <algorithm>
#include <cmath>

namespace solitaire {
namespace {

constexpr double kHeadHeight = 1.8;  // metres
constexpr double kThickestFloor = 0.6;
constexpr double kSmallestFloor = 2;  // square metres
constexpr double kContact = 0.05;     // metres
constexpr std::size_t kMostComparisons = 20'000'000;

bool covers(const Box3& box, const Vec3& point) {
  return box.low[0] <= point[0] && point[0] <= box.high[0] && box.low[1] <= point[1] &&
         point[1] <= box.high[1];
}

bool overlap_from_above(const Box3& a, const Box3& b) {
  return a.low[0] < b.high[0] && b.low[0] < a.high[0] && a.low[1] < b.high[1] && b.low[1] < a.high[1];
}

class Storeys {
 public:
  explicit Storeys(const Scene& scene) : scene_(scene) {
    for (const SceneObject& object : scene.objects) boxes_.push_back(bounds(object.box));
  }

  std::vector<Level> levels() const {
    std::vector<Level> levels;
    for (const double floor : floors()) levels.push_back({floor, {}, {}});
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      const auto above = std::find_if(levels.begin() + 1, levels.end(), [&](const Level& level) {
        return level.floor > boxes_[i].low[2] + kContact;
      });
      std::prev(above)->standing.push_back(i);
    }
    for (Level& level : levels) lift_overhead(level);
    return levels;
  }

 private:
  /// Returns where the levels begin.
  std::vector<double> floors() const {
    std::vector<std::size_t> slabs;
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      if (is_slab(i)) slabs.push_back(i);
    }
    std::stable_sort(slabs.begin(), slabs.end(),
                     [&](std::size_t a, std::size_t b) { return boxes_[a].low[2] < boxes_[b].low[2]; });
    std::vector<double> floors{lowest()};
    for (const std::size_t slab : slabs) {
      const double base = boxes_[slab].low[2];
      if (base >= floors.back() + kHeadHeight && carries_something(slab)) floors.push_back(base);
    }
    return floors;
  }

  double lowest() const {
    double low = boxes_.front().low[2];
    for (const Box3& box : boxes_) low = std::min(low, box.low[2]);
    return low;
  }

  bool is_slab(std::size_t index) const {
    const Vec3& size = scene_.objects[index].box.size;
    return size[2] <= kThickestFloor && size[0] * size[1] >= kSmallestFloor;
  }

  bool carries_something(std::size_t slab) const {
    const Box3& floor = boxes_[slab];
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      const bool touches = std::abs(boxes_[i].low[2] - floor.high[2]) <= kContact;
      if (i != slab && touches && covers(floor, scene_.objects[i].box.center)) return true;
    }
    return false;
  }

  /// Takes what hangs above head height over something else out of what stands on the level.
  void lift_overhead(Level& level) const {
    const auto is_high = [&](std::size_t i) { return boxes_[i].low[2] >= level.floor + kHeadHeight; };
    const auto high = static_cast<std::size_t>(std::ranges::count_if(level.standing, is_high));
    if (high * level.standing.size() > kMostComparisons) return;
    const std::vector<std::size_t> all = level.standing;
    const auto hangs = [&](std::size_t i) {
      return is_high(i) && std::ranges::any_of(all, [&](std::size_t other) {
               return !is_high(other) && overlap_from_above(boxes_[i], boxes_[other]);
             });
    };
    std::ranges::copy_if(all, std::back_inserter(level.overhead), hangs);
    std::erase_if(level.standing, hangs);
  }

  const Scene& scene_;
  std::vector<Box3> boxes_;
};

}  // namespace

std::vector<Level> levels_of(const Scene& scene) {
  return scene.objects.empty() ? std::vector<Level>() : Storeys(scene).levels();
}

}  // namespace solitaire
