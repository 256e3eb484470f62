#include "tests/tiles/enumeration.h"

namespace solitaire::tiles {

Enumeration::Enumeration(const Problem& problem) : problem_(problem) {
  Grid map(problem.size());
  extend(map, 0);
  double sum = 0;
  for (auto& [tiles, weight] : probability_) sum += weight;
  for (auto& [tiles, weight] : probability_) weight /= sum;
}

void Enumeration::extend(Grid& map, std::size_t site) {
  const Topology& topology = problem_.topology();
  if (site == map.tiles.size()) {
    if (problem_.violation(map) == 0) probability_.emplace(key(map), std::exp(log_weight(map)));
    return;
  }
  const Point at = map.size.point(site);
  for (Tile tile = 0; tile < problem_.style().tileset.size(); ++tile) {
    if (!problem_.domain(site).contains(tile)) continue;
    map[site] = tile;
    bool fits = true;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const std::size_t before = topology.neighbor(at, axis, -1), after = topology.neighbor(at, axis, 1);
      if (before != Topology::kNone && before <= site)
        fits = fits && problem_.allowed(axis, before, map[before], site, tile);
      if (after != Topology::kNone && after < site)
        fits = fits && problem_.allowed(axis, site, tile, after, map[after]);
    }
    if (fits) extend(map, site + 1);
  }
  map[site] = kHole;
}

double Enumeration::log_weight(const Grid& map) const {
  double sum = 0;
  for (const SoftShape& shape : problem_.style().shapes) {
    for_each_point(map.size, [&](const Point& at) {
      PatchCode code = 0;
      unsigned place = 0;
      ZoneSet zones = 0;
      bool whole = true;
      for_each_point(shape.patches.shape(), [&](const Point& offset) {
        const std::size_t site = problem_.topology().site(at, offset);
        whole = whole && site != Topology::kNone;
        if (!whole) return;
        code |= PatchCode{map[site]} << (place++ * shape.patches.bits());
        zones |= ZoneSet{1} << problem_.zone(site);
      });
      if (whole) sum += shape.log_weight(zones, shape.patches.find(code));
    });
  }
  return sum;
}

void Enumeration::draw(const Grid& map) {
  ++draws_;
  if (!probability_.contains(key(map))) ++strangers_;
  ++drawn_[key(map)];
}

Enumeration::Fit Enumeration::fit() const {
  double sum = 0, rare_expected = 0, rare_drawn = 0;
  std::size_t cells = 0;
  for (const auto& [tiles, probability] : probability_) {
    const double expected = probability * static_cast<double>(draws_);
    const auto found = drawn_.find(tiles);
    const double drawn = found == drawn_.end() ? 0 : static_cast<double>(found->second);
    if (expected < 5) {
      rare_expected += expected;
      rare_drawn += drawn;
      continue;
    }
    sum += (drawn - expected) * (drawn - expected) / expected;
    ++cells;
  }
  if (rare_expected >= 5) {
    sum += (rare_drawn - rare_expected) * (rare_drawn - rare_expected) / rare_expected;
    ++cells;
  }
  return {sum, cells - 1};
}

double Enumeration::deviations() const {
  const auto [sum, degrees] = fit();
  const double part = 2.0 / (9 * static_cast<double>(degrees));
  return (std::cbrt(sum / static_cast<double>(degrees)) - (1 - part)) / std::sqrt(part);
}

double Enumeration::score_deviations() const {
  double expected = 0, square = 0, sum = 0;
  for (const auto& [tiles, probability] : probability_) {
    const double score = std::log(probability);
    expected += probability * score;
    square += probability * score * score;
    const auto found = drawn_.find(tiles);
    if (found != drawn_.end()) sum += score * static_cast<double>(found->second);
  }
  const auto draws = static_cast<double>(draws_);
  return (sum / draws - expected) / std::sqrt((square - expected * expected) / draws);
}

}  // namespace solitaire::tiles
