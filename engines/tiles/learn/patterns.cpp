#include "engines/tiles/learn/patterns.h"

#include <cmath>

#include "engines/tiles/learn/edge_pairs.h"

namespace solitaire::tiles {
namespace {

Topology topology_of(const Exemplar& exemplar) { return {exemplar.grid.size, exemplar.periodic}; }

template <class Visit>
void for_each_patch(const Grid& grid, const Topology& topology, const Size& shape, unsigned bits,
                    Visit visit) {
  PatchCode code = 0;
  for_each_point(grid.size, [&](const Point& at) {
    if (patch_at(grid, topology, shape, at, bits, code)) visit(code);
  });
}

/// Calls `visit(axis, first, second)` for all pairs of neighbours without holes.
template <class Visit>
void for_each_pair(const Exemplar& exemplar, Visit visit) {
  const Topology topology = topology_of(exemplar);
  for_each_point(exemplar.grid.size, [&](const Point& at) {
    const Tile first = exemplar.grid.at(at);
    for (std::size_t axis = 0; axis < kAxes && first != kHole; ++axis) {
      const std::size_t next = topology.neighbor(at, axis, 1);
      if (next == Topology::kNone || exemplar.grid[next] == kHole) continue;
      visit(axis, first, exemplar.grid[next]);
    }
  });
}

void allow_listed_pairs(const std::vector<ListedPairs>& listed, PairRules& rules) {
  for (const ListedPairs& pairs : listed) {
    pairs.first.for_each([&](Tile first) {
      pairs.second.for_each([&](Tile second) { rules.allow(pairs.axis, first, second); });
    });
  }
}

void learn_frequencies(Style& style) {
  style.frequencies.assign(style.zones, std::vector<double>(style.tileset.size()));
  for (const Exemplar& exemplar : style.exemplars) {
    if (exemplar.negative) continue;
    for (const Tile tile : exemplar.grid.tiles) {
      if (tile != kHole) style.frequencies[exemplar.zone][tile] += 1;
    }
  }
  for (std::vector<double>& frequency : style.frequencies) {
    double sum = 0;
    for (const double each : frequency) sum += each;
    for (double& each : frequency) {
      each = sum > 0 ? each / sum : 1 / static_cast<double>(frequency.size());
    }
  }
}

}  // namespace

bool patch_at(const Grid& grid, const Topology& topology, const Size& shape, const Point& at, unsigned bits,
              PatchCode& code) {
  code = 0;
  unsigned shift = 0;
  bool whole = true;
  for_each_point(shape, [&](const Point& offset) {
    const std::size_t site = whole ? topology.site(at, offset) : Topology::kNone;
    whole = site != Topology::kNone && grid[site] != kHole;
    if (whole) code |= PatchCode{grid[site]} << shift;
    shift += bits;
  });
  return whole;
}

void collect_patches(const Exemplar& exemplar, PatchIndex& patches) {
  for_each_patch(exemplar.grid, topology_of(exemplar), patches.shape(), patches.bits(),
                 [&](PatchCode code) { patches.insert(code); });
}

PatchCounts count_patches(const Grid& grid, const Topology& topology, const PatchIndex& patches) {
  PatchCounts counts{std::vector<double>(patches.size() + 1), 0};
  for_each_patch(grid, topology, patches.shape(), patches.bits(), [&](PatchCode code) {
    counts.count[patches.find(code)] += 1;
    counts.total += 1;
  });
  return counts;
}

PatchCounts count_patches(const Style& style, std::size_t zone, const PatchIndex& patches) {
  PatchCounts sum{std::vector<double>(patches.size() + 1), 0};
  for (const Exemplar& exemplar : style.exemplars) {
    if (exemplar.negative || exemplar.zone != zone) continue;
    const PatchCounts counts = count_patches(exemplar.grid, topology_of(exemplar), patches);
    for (std::size_t number = 0; number < sum.count.size(); ++number)
      sum.count[number] += counts.count[number];
    sum.total += counts.total;
  }
  return sum;
}

void learn_pairs(Style& style) {
  style.pairs.assign(style.zones, PairRules(style.tileset.size()));
  for (PairRules& rules : style.pairs) {
    allow_labelled_pairs(style.tileset, rules);
    allow_listed_pairs(style.listed, rules);
  }
  for (const bool negative : {false, true}) {
    for (const Exemplar& exemplar : style.exemplars) {
      if (exemplar.negative != negative || !(negative || style.learns_from_exemplars)) continue;
      PairRules& rules = style.pairs[exemplar.zone];
      for_each_pair(exemplar, [&](std::size_t axis, Tile first, Tile second) {
        negative ? rules.forbid(axis, first, second) : rules.allow(axis, first, second);
      });
    }
  }
  learn_frequencies(style);
}

void add_step_shape(Style& style, const Size& shape, double epsilon) {
  PatchIndex patches(shape, style.tileset.size());
  for (const Exemplar& exemplar : style.exemplars) {
    if (!exemplar.negative) collect_patches(exemplar, patches);
  }
  std::vector<std::vector<double>> weights(style.zones);
  for (std::size_t zone = 0; zone < style.zones; ++zone) {
    const PatchCounts counts = count_patches(style, zone, patches);
    weights[zone].assign(patches.size() + 1, 0);
    for (std::size_t number = 1; number <= patches.size(); ++number) {
      if (counts.count[number] > 0) weights[zone][number] = std::log1p(epsilon);
    }
  }
  style.shapes.push_back({std::move(patches), std::move(weights)});
}

void add_biases(Style& style) {
  PatchIndex patches({{1, 1, 1}}, style.tileset.size());
  std::vector<double> weights(1);
  bool any = false;
  for (std::size_t tile = 0; tile < style.tileset.size(); ++tile) {
    patches.insert(PatchCode{tile});
    weights.push_back(std::log(style.tileset[static_cast<Tile>(tile)].bias));
    any = any || weights.back() != 0;
  }
  if (any) style.shapes.push_back({std::move(patches), std::vector(style.zones, weights)});
}

}  // namespace solitaire::tiles
