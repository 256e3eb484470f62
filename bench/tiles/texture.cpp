#include "bench/tiles/texture.h"

#include <array>

namespace solitaire::tiles::bench {
namespace {

constexpr std::array<Point, 12> kCausal{{{-2, -2, 0},
                                         {-1, -2, 0},
                                         {0, -2, 0},
                                         {1, -2, 0},
                                         {2, -2, 0},
                                         {-2, -1, 0},
                                         {-1, -1, 0},
                                         {0, -1, 0},
                                         {1, -1, 0},
                                         {2, -1, 0},
                                         {-2, 0, 0},
                                         {-1, 0, 0}}};

/// Returns the tile at a distance; outside of the grid is a hole.
Tile beside(const Grid& grid, const Point& at, const Point& distance) {
  const std::size_t site = Topology{grid.size, {}}.site(at, distance);
  return site == Topology::kNone ? kHole : grid[site];
}

int difference(const Grid& map, const Point& at, const Grid& exemplar, const Point& from) {
  int different = 0;
  for (const Point& distance : kCausal) {
    if (beside(map, at, distance) != beside(exemplar, from, distance)) ++different;
  }
  return different;
}

}  // namespace

Grid synthesize_texture(const Style& style, const Size& size, RandomStream& random) {
  const Grid& exemplar = style.exemplars.front().grid;
  Grid map(size);
  for_each_point(size, [&](const Point& at) {
    int least = static_cast<int>(kCausal.size()) + 1;
    std::uint64_t ties = 0;
    for_each_point(exemplar.size, [&](const Point& from) {
      const int different = difference(map, at, exemplar, from);
      if (different > least) return;
      ties = different < least ? 1 : ties + 1;
      least = different;
      if (random.below(ties) == 0) map[size.site(at)] = exemplar.at(from);
    });
  });
  return map;
}

std::size_t broken_pairs(const Style& style, const Grid& map) {
  std::size_t broken = 0;
  const Topology topology{map.size, {}};
  for_each_point(map.size, [&](const Point& at) {
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const std::size_t next = topology.neighbor(at, axis, 1);
      if (next != Topology::kNone && !style.pairs[0].allowed(axis, map.at(at), map[next])) ++broken;
    }
  });
  return broken;
}

}  // namespace solitaire::tiles::bench
