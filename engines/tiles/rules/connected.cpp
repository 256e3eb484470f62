#include "engines/tiles/rules/connected.h"

#include "engines/tiles/rules/components.h"

namespace solitaire::tiles {
std::uint64_t Connected::violation(const Grid& map) const {
  Components components(map.tiles.size());
  std::uint64_t count = 0;
  for (std::size_t site = 0; site < map.tiles.size(); ++site) {
    if (open_[map[site]] != 0) ++count;
  }
  for_each_point(map.size, [&](const Point& at) {
    const std::size_t site = map.size.site(at);
    const Sides open = open_[map[site]];
    for (std::size_t axis = 0; axis < kAxes && open != 0; ++axis) {
      if ((open & side(axis, 1)) == 0) continue;
      const std::size_t next = topology_.neighbor(at, axis, 1);
      if (next == Topology::kNone || (open_[map[next]] & side(axis, -1)) == 0) continue;
      if (components.join(site, next)) --count;
    }
  });
  return count > 1 ? count - 1 : 0;
}

TileMask Connected::passable() const {
  TileMask tiles;
  for (std::size_t tile = 0; tile < open_.size(); ++tile) {
    if (open_[tile] != 0) tiles.insert(static_cast<Tile>(tile));
  }
  return tiles;
}

}  // namespace solitaire::tiles
