#include "engines/tiles/rules/path.h"

#include <deque>

namespace solitaire::tiles {

/// Closed steps cost 1 and open ones nothing, so that a queue with two ends holds the sites in order.
std::uint64_t Path::violation(const Grid& map) const {
  constexpr std::uint64_t kFar = UINT64_MAX;
  std::vector<std::uint64_t> cost(map.tiles.size(), kFar);
  std::deque<std::size_t> queue{from_};
  cost[from_] = 0;
  while (!queue.empty()) {
    const std::size_t site = queue.front();
    queue.pop_front();
    if (site == to_) break;
    const Point at = map.size.point(site);
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      for (const int step : {1, -1}) {
        const std::size_t next = topology_.neighbor(at, axis, step);
        if (next == Topology::kNone) continue;
        const bool is_open =
            (open_[map[site]] & side(axis, step)) != 0 && (open_[map[next]] & side(axis, -step)) != 0;
        const std::uint64_t reached = cost[site] + (is_open ? 0 : 1);
        if (reached >= cost[next]) continue;
        cost[next] = reached;
        is_open ? queue.push_front(next) : queue.push_back(next);
      }
    }
  }
  return cost[to_];
}

}  // namespace solitaire::tiles
