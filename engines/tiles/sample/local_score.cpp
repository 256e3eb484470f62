#include "engines/tiles/sample/local_score.h"

#include "engines/tiles/learn/patterns.h"

namespace solitaire::tiles {

LocalScore::LocalScore(const Problem& problem, double log_broken)
    : problem_(problem), log_broken_(log_broken) {
  for (const SoftShape& shape : problem.style().shapes) {
    auto& offsets = offsets_.emplace_back();
    for_each_point(shape.patches.shape(), [&](const Point& at) { offsets.push_back(at); });
  }
}

std::size_t LocalScore::broken_at(const Grid& map, std::size_t site) const {
  const Point at = map.size.point(site);
  std::size_t broken = 0;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const std::size_t next = problem_.topology().neighbor(at, axis, 1);
    const std::size_t before = problem_.topology().neighbor(at, axis, -1);
    if (next != Topology::kNone && !problem_.allowed(axis, site, map[site], next, map[next])) ++broken;
    if (before != Topology::kNone && !problem_.allowed(axis, before, map[before], site, map[site])) ++broken;
  }
  return broken;
}

double LocalScore::at(const Grid& map, std::size_t site) const {
  double sum = log_broken_ * static_cast<double>(broken_at(map, site));
  const Point at = map.size.point(site);
  for (std::size_t shape = 0; shape < offsets_.size(); ++shape) {
    const SoftShape& soft = problem_.style().shapes[shape];
    for (const Point& own : offsets_[shape]) {
      const std::size_t anchor = problem_.topology().site(at, {-own[0], -own[1], -own[2]});
      if (anchor == Topology::kNone) continue;
      PatchCode code = 0;
      const Point from = map.size.point(anchor);
      if (!patch_at(map, problem_.topology(), soft.patches.shape(), from, soft.patches.bits(), code))
        continue;
      ZoneSet zones = 0;
      for (const Point& offset : offsets_[shape]) {
        zones |= ZoneSet{1} << problem_.zone(problem_.topology().site(from, offset));
      }
      sum += soft.log_weight(zones, soft.patches.find(code));
    }
  }
  return sum;
}

}  // namespace solitaire::tiles
