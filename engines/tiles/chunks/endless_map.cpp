#include "engines/tiles/chunks/endless_map.h"

#include <algorithm>
#include <stdexcept>

#include "base/floor_division.h"
#include "base/hash.h"
#include "engines/tiles/sample/frontier.h"
#include "engines/tiles/sample/sampler.h"

namespace solitaire::tiles {
namespace {

/// With so many layers, hardly a tile of the periodic map is left where it was.
constexpr std::size_t kLayers = 16;
constexpr int kLength = 12, kThickness = 3;  // of windows
/// Extents of the periodic map that are tried one after another.
constexpr int kExtents[] = {40, 30, 24, 20};

}  // namespace

EndlessMap::EndlessMap(std::shared_ptr<const Style> style, std::uint64_t seed)
    : style_(std::move(style)), seed_(seed), reach_{1, 1} {
  for (std::size_t axis = 0; axis < 2; ++axis) {
    for (const SoftShape& shape : style_->shapes)
      reach_[axis] = std::max<std::int64_t>(reach_[axis], shape.patches.shape().extent[axis] - 1);
  }
  for (std::size_t number = 0; number < kLayers; ++number) {
    RandomStream random(seed_, Purpose::kTiles, mix(UINT64_MAX, number));
    Layer& layer = layers_.emplace_back();
    layer.size.at(number % 2) = kLength;
    layer.size.at(1 - number % 2) = kThickness;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      layer.step[axis] = layer.size.at(axis) + reach_[axis];
      layer.offset[axis] =
          static_cast<std::int64_t>(random.below(static_cast<std::uint64_t>(layer.step[axis])));
    }
  }
}

Outcome EndlessMap::prepare(const StopSignal& stop) {
  SamplerOptions options;
  options.seed = seed_;
  for (const int extent : kExtents) {
    const Problem torus(style_, {{{extent, extent, 1}}, {true, true, false}});
    const std::vector<TileMask> domains = consistent_domains(torus);
    if (domains.empty()) continue;
    Sample sample = sample_windows(torus, domains, options, 0, stop);
    if (sample.outcome == Outcome::kNone) continue;
    base_ = std::move(sample.map);
    return sample.outcome;
  }
  return Outcome::kGaveUp;
}

Grid EndlessMap::region(const FarPoint& from, const Size& size, const StopSignal& stop) const {
  for (const std::int64_t at : from) {
    if (at < -kFarthest || at > kFarthest) throw std::length_error("a region is too far from the origin");
  }
  const Part wanted{from, {from[0] + size.width(), from[1] + size.height()}};
  std::vector<Part> parts{wanted};  // those that are needed after each layer, from the last to the first
  for (std::size_t layer = kLayers; layer-- > 0;) parts.push_back(seen_by(layers_[layer], parts.back()));
  const Part whole = parts.back();
  Grid map = base_of(whole);
  const Problem problem(style_, {map.size, {}});
  for (std::size_t layer = 0; layer < kLayers; ++layer)
    redraw(layer, parts[kLayers - 1 - layer], whole, problem, map, stop);
  Grid result(size);
  for_each_point(size, [&](const Point& at) {
    result[size.site(at)] = map.at({static_cast<int>(from[0] - whole.from[0]) + at[0],
                                    static_cast<int>(from[1] - whole.from[1]) + at[1], 0});
  });
  return result;
}

/// Returns the numbers in the lattice of the windows that have a place in the part.
EndlessMap::Part EndlessMap::windows_that_meet(const Layer& layer, const Part& part) const {
  Part numbers;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const std::int64_t last_place = layer.size.at(axis) - 1;
    numbers.from[axis] = -floor_divide(layer.offset[axis] + last_place - part.from[axis], layer.step[axis]);
    numbers.to[axis] = floor_divide(part.to[axis] - 1 - layer.offset[axis], layer.step[axis]) + 1;
  }
  return numbers;
}

/// Returns the part on which another one depends by a layer: the windows that meet it, with what their
/// factors see.
EndlessMap::Part EndlessMap::seen_by(const Layer& layer, const Part& part) const {
  const Part numbers = windows_that_meet(layer, part);
  Part seen = part;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (numbers.from[axis] >= numbers.to[axis]) return part;
    const std::int64_t first = layer.offset[axis] + numbers.from[axis] * layer.step[axis];
    const std::int64_t last = layer.offset[axis] + (numbers.to[axis] - 1) * layer.step[axis];
    seen.from[axis] = std::min(part.from[axis], first - reach_[axis]);
    seen.to[axis] = std::max(part.to[axis], last + layer.size.at(axis) + reach_[axis]);
  }
  return seen;
}

Grid EndlessMap::base_of(const Part& part) const {
  const std::int64_t width = part.to[0] - part.from[0], height = part.to[1] - part.from[1];
  if (width > static_cast<std::int64_t>(kMostSites) / height)
    throw std::length_error("a region of an endless map is too large; ask for several smaller ones");
  Grid map(Size{{static_cast<int>(width), static_cast<int>(height), 1}});
  for_each_point(map.size, [&](const Point& at) {
    map[map.size.site(at)] =
        base_.at({static_cast<int>(floor_modulo(part.from[0] + at[0], base_.size.width())),
                  static_cast<int>(floor_modulo(part.from[1] + at[1], base_.size.height())), 0});
  });
  return map;
}

/// Redraws those windows of a layer that meet the part; the map and the problem are of the whole.
void EndlessMap::redraw(std::size_t number, const Part& part, const Part& whole, const Problem& problem,
                        Grid& map, const StopSignal& stop) const {
  const Layer& layer = layers_[number];
  const Part numbers = windows_that_meet(layer, part);
  Frontier frontier(problem);
  Weights weights(*style_);
  const std::size_t along = number % 2;
  std::vector<std::uint32_t> sites;
  for (std::int64_t j = numbers.from[1]; j < numbers.to[1]; ++j) {
    for (std::int64_t i = numbers.from[0]; i < numbers.to[0]; ++i) {
      if (stop.stopped()) throw Interrupted();
      const int left = static_cast<int>(layer.offset[0] + i * layer.step[0] - whole.from[0]);
      const int top = static_cast<int>(layer.offset[1] + j * layer.step[1] - whole.from[1]);
      sites.clear();
      for (int a = 0; a < kLength; ++a) {  // across first
        for (int b = 0; b < kThickness; ++b) {
          const Point at = along == 0 ? Point{left + a, top + b, 0} : Point{left + b, top + a, 0};
          sites.push_back(static_cast<std::uint32_t>(map.size.site(at)));
        }
      }
      RandomStream random(mix(seed_, number), Purpose::kTiles,
                          mix(static_cast<std::uint64_t>(i), static_cast<std::uint64_t>(j)));
      frontier.redraw(map, sites, weights, random);
    }
  }
}

}  // namespace solitaire::tiles
