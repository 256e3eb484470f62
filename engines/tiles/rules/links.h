#pragma once
#include <vector>

#include "engines/tiles/model/grid.h"
#include "engines/tiles/model/tileset.h"

namespace solitaire::tiles {

/// Calls `visit(site, next)` for all neighbours of a map each of which is open towards the other. `open` has
/// the open sides of each tile.
template <class Visit>
void for_each_link(const Topology& topology, const std::vector<Sides>& open, const Grid& map, Visit visit) {
  for_each_point(map.size, [&](const Point& at) {
    const std::size_t site = map.size.site(at);
    const Sides here = open[map[site]];
    for (std::size_t axis = 0; axis < kAxes && here != 0; ++axis) {
      if ((here & side(axis, 1)) == 0) continue;
      const std::size_t next = topology.neighbor(at, axis, 1);
      if (next != Topology::kNone && (open[map[next]] & side(axis, -1)) != 0) visit(site, next);
    }
  });
}

}  // namespace solitaire::tiles
