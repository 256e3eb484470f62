#include "engines/tiles/sample/refill.h"

#include <algorithm>
#include <stdexcept>

namespace solitaire::tiles {
namespace {

/// Returns how far a factor reaches from one of its sites.
int reach_of(const Style& style) {
  int reach = 1;
  for (const SoftShape& shape : style.shapes) {
    reach = std::max(reach, *std::ranges::max_element(shape.patches.shape().extent) - 1);
  }
  return reach;
}

Point plus(const Point& a, const Point& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }

/// Returns the problem of the sites around a box, of which all outside the box have the map's tiles.
Problem part_of(const Problem& whole, const Grid& map, const Box& around, const Box& box) {
  Problem part(whole.shared_style(), {around.size(), {}});
  std::vector<std::uint8_t> zones;
  for_each_point(part.size(), [&](const Point& offset) {
    const Point at = plus(around.from, offset);
    const std::size_t site = map.size.site(at);
    zones.push_back(static_cast<std::uint8_t>(whole.zone(site)));
    const TileMask tiles = box.contains(at) ? whole.domain(site) : TileMask::of(map[site]);
    part.add({"", {static_cast<std::uint32_t>(part.size().site(offset))}, tiles});
  });
  part.set_zones(std::move(zones));
  return part;
}

}  // namespace

Outcome refill(const Problem& problem, const Box& box, const SamplerOptions& options, const StopSignal& stop,
               Grid& map) {
  if (!problem.global_rules().empty() || problem.topology().periodic != std::array<bool, kAxes>{}) {
    throw std::invalid_argument("a part of a map with global rules or rings cannot be made on its own");
  }
  // Factors that see a site of the box see nothing beyond their reach.
  const Box around = grown(box, reach_of(problem.style()), problem.size());
  const Problem part = part_of(problem, map, around, box);
  const Sample sample = sample_windows(part, consistent_domains(part), options, 1, stop);
  if (sample.outcome != Outcome::kFound) return sample.outcome;
  for_each_point(part.size(), [&](const Point& offset) {
    map[map.size.site(plus(around.from, offset))] = sample.map.at(offset);
  });
  return Outcome::kFound;
}

}  // namespace solitaire::tiles
