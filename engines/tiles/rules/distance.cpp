#include "engines/tiles/rules/distance.h"

#include <algorithm>
#include <cstdlib>
#include <vector>

namespace solitaire::tiles {

std::uint64_t Distance::violation(const Grid& map) const {
  std::vector<Point> places;
  for (std::size_t site = 0; site < map.tiles.size(); ++site) {
    if (tiles_.contains(map[site])) places.push_back(map.size.point(site));
  }
  std::uint64_t near = 0;
  for (std::size_t b = 1; b < places.size(); ++b) {
    for (std::size_t a = 0; a < b; ++a) near += steps_between(places[a], places[b]) < least_ ? 1 : 0;
  }
  return near;
}

int Distance::steps_between(const Point& a, const Point& b) const {
  int steps = 0;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const int along = std::abs(a[axis] - b[axis]);
    steps += topology_.periodic[axis] ? std::min(along, topology_.size.extent[axis] - along) : along;
  }
  return steps;
}

}  // namespace solitaire::tiles
