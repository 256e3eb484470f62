#include "engines/tiles/count/count.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>
#include <unordered_map>

#include "base/hash.h"
#include "engines/tiles/sample/window_plan.h"

namespace solitaire::tiles {
namespace {

constexpr std::size_t kMostStates = 4'000'000;

/// A number of maps: exact up to 2^127, and always its logarithm.
class MapCount {
 public:
  static MapCount one() { return MapCount(1, 0); }
  MapCount() = default;

  void operator+=(const MapCount& other) {
    if (other.log2_ == -INFINITY) return;
    const double most = std::max(log2_, other.log2_), least = std::min(log2_, other.log2_);
    log2_ = most + std::log2(1 + std::exp2(least - most));
    exact_ += other.exact_;
  }
  std::string text() const {
    if (log2_ == -INFINITY) return "0";
    if (log2_ > 126.9) return fmt::format("2^{:.1f}", log2_);
    std::string digits;
    for (PatchCode rest = exact_; rest > 0; rest /= 10)
      digits += static_cast<char>('0' + static_cast<int>(rest % 10));
    return {digits.rbegin(), digits.rend()};
  }

 private:
  MapCount(PatchCode exact, double log2) : exact_(exact), log2_(log2) {}

  PatchCode exact_ = 0;  // modulo 2^128
  double log2_ = -INFINITY;
};

struct KeyHash {
  std::size_t operator()(FrontierKey key) const {
    return mix(static_cast<std::uint64_t>(key), static_cast<std::uint64_t>(key >> 64U));
  }
};
using States = std::unordered_map<FrontierKey, MapCount, KeyHash>;

/// Returns all sites, so that the frontier runs along the shortest axes.
std::vector<std::uint32_t> sites_in_order(const Size& size) {
  std::array<std::size_t, kAxes> axes{0, 1, 2};
  std::ranges::stable_sort(axes, std::greater<>(), [&](std::size_t axis) { return size.extent[axis]; });
  std::vector<std::uint32_t> sites;
  Point at{};
  for (at[axes[0]] = 0; at[axes[0]] < size.extent[axes[0]]; ++at[axes[0]]) {
    for (at[axes[1]] = 0; at[axes[1]] < size.extent[axes[1]]; ++at[axes[1]]) {
      for (at[axes[2]] = 0; at[axes[2]] < size.extent[axes[2]]; ++at[axes[2]]) {
        sites.push_back(static_cast<std::uint32_t>(size.site(at)));
      }
    }
  }
  return sites;
}

States after(const PlanStep& step, const States& before, unsigned bits, const StopSignal& stop) {
  States states;
  std::size_t seen = 0;
  for (const auto& [key, count] : before) {
    if (seen++ % 4096 == 0 && stop.stopped()) throw Interrupted();
    TileMask tiles = step.tiles;
    for (const ClosingPair& pair : step.pairs) {
      const auto other = static_cast<Tile>((key >> pair.slot) & ((1U << bits) - 1));
      tiles &= pair.rules->beside(other, pair.axis, pair.step);
    }
    const FrontierKey kept = key & step.kept;
    tiles.for_each([&, &number = count](Tile tile) {
      states[step.needed ? kept | FrontierKey{tile} << step.slot : kept] += number;
    });
  }
  return states;
}

}  // namespace

std::optional<std::string> count_maps(const Problem& problem, const StopSignal& stop) {
  const Problem pairs_only = problem.without_soft_factors();
  WindowPlan plan(pairs_only);
  Weights weights(pairs_only.style());
  const std::vector<std::uint32_t> sites = sites_in_order(problem.size());
  if (!plan.lay_out(Grid(problem.size()), sites, weights)) return std::nullopt;
  const unsigned bits = PatchIndex::bits_for(problem.style().tileset.size());
  States states{{FrontierKey{0}, MapCount::one()}};
  for (const PlanStep& step : plan.steps()) {
    states = after(step, states, bits, stop);
    if (states.size() > kMostStates) return std::nullopt;
  }
  return states.empty() ? "0" : states.begin()->second.text();
}

}  // namespace solitaire::tiles
