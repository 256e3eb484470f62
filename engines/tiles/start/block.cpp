#include "engines/tiles/start/block.h"

#include <algorithm>

namespace solitaire::tiles {
namespace {

std::size_t place_in(const Box& box, const Point& at) {
  return box.size().site({at[0] - box.from[0], at[1] - box.from[1], at[2] - box.from[2]});
}

}  // namespace

Box grown(const Box& box, int margin, const Size& size) {
  Box result;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    result.from[axis] = std::max(0, box.from[axis] - margin);
    result.to[axis] = std::min(size.extent[axis], box.to[axis] + margin);
  }
  return result;
}

Block::Block(const Problem& problem, std::span<const TileMask> domains, const Grid& map, const Box& box)
    : problem_(&problem) {
  const Topology& topology = problem.topology();
  const Size inner = box.size();
  const std::size_t count = inner.volume();
  sites_.reserve(count);
  domains_.reserve(count);
  neighbors_.reserve(count);
  for_each_point(inner, [&](const Point& offset) {
    const Point at{box.from[0] + offset[0], box.from[1] + offset[1], box.from[2] + offset[2]};
    sites_.push_back(static_cast<std::uint32_t>(problem.size().site(at)));
    domains_.push_back(domains[sites_.back()]);
    auto& neighbors = neighbors_.emplace_back();
    neighbors.fill(-1);
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      for (const int step : {1, -1}) {
        const std::size_t site = topology.neighbor(at, axis, step);
        if (site == Topology::kNone) continue;
        const Point beside = problem.size().point(site);
        if (box.contains(beside)) {
          neighbors[2 * axis + (step > 0 ? 0 : 1)] = static_cast<std::int32_t>(place_in(box, beside));
        }
      }
    }
  });
  is_changed_.assign(count, true);
  changed_.resize(count);
  for (std::uint32_t place = 0; place < count; ++place) {
    changed_[place] = place;
    meet_standing(map, place);
  }
}

/// Leaves only what may be beside tiles that stand around the block.
void Block::meet_standing(const Grid& map, std::size_t place) {
  const Point at = problem_->size().point(sites_[place]);
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    for (const int step : {1, -1}) {
      if (neighbors_[place][2 * axis + (step > 0 ? 0 : 1)] >= 0) continue;
      const std::size_t site = problem_->topology().neighbor(at, axis, step);
      if (site == Topology::kNone || map[site] == kHole) continue;
      const PairRules& pairs = problem_->pairs(zone(place), problem_->zone(site));
      domains_[place] &= pairs.beside(map[site], axis, -step);
    }
  }
}

void Block::restrict(std::size_t place, const TileMask& tiles) {
  const TileMask left = domains_[place] & tiles;
  if (left == domains_[place]) return;
  domains_[place] = left;
  touched_.push_back(static_cast<std::uint32_t>(place));
  if (is_changed_[place]) return;
  is_changed_[place] = true;
  changed_.push_back(static_cast<std::uint32_t>(place));
}

bool Block::propagate() {
  while (!changed_.empty()) {
    const std::size_t place = changed_.back();
    changed_.pop_back();
    is_changed_[place] = false;
    if (domains_[place].empty()) return false;
    for_each_neighbor(place, [&](std::size_t neighbor, std::size_t axis, int step) {
      const PairRules& pairs = problem_->pairs(zone(place), zone(neighbor));
      restrict(neighbor, pairs.beside_any(domains_[place], axis, step));
    });
  }
  return true;
}

void Block::write_to(Grid& map) const {
  for (std::size_t place = 0; place < size(); ++place) map[sites_[place]] = domains_[place].lowest();
}

}  // namespace solitaire::tiles
