#include "engines/tiles/rules/distance.h"

#include <algorithm>
#include <cstdlib>
#include <vector>

namespace solitaire::tiles {
namespace {

std::vector<Point> places_of(const Grid& map, const TileMask& tiles) {
  std::vector<Point> places;
  for (std::size_t site = 0; site < map.tiles.size(); ++site) {
    if (tiles.contains(map[site])) places.push_back(map.size.point(site));
  }
  return places;
}

int steps_between(const Topology& topology, const Point& a, const Point& b) {
  int steps = 0;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const int along = std::abs(a[axis] - b[axis]);
    steps += topology.periodic[axis] ? std::min(along, topology.size.extent[axis] - along) : along;
  }
  return steps;
}

}  // namespace

std::uint64_t Distance::violation(const Grid& map) const {
  const std::vector<Point> places = places_of(map, tiles_);
  std::uint64_t near = 0;
  for (std::size_t b = 1; b < places.size(); ++b) {
    for (std::size_t a = 0; a < b; ++a)
      near += steps_between(topology_, places[a], places[b]) < least_ ? 1 : 0;
  }
  return near;
}

std::uint64_t PairDistance::violation(const Grid& map) const {
  std::uint64_t near = 0;
  const std::vector<Point> others = places_of(map, others_);
  for (const Point& a : places_of(map, tiles_)) {
    for (const Point& b : others) near += a != b && steps_between(topology_, a, b) < least_ ? 1 : 0;
  }
  return near;
}

}  // namespace solitaire::tiles
