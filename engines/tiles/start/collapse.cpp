#include "engines/tiles/start/collapse.h"

#include <cmath>
#include <functional>
#include <queue>

#include "engines/tiles/model/uniform.h"

namespace solitaire::tiles {
namespace {

/// The weight of tiles that no exemplar of the zone has.
constexpr double kRare = 1e-3;

double weight_of(const std::vector<double>& frequencies, Tile tile) {
  return frequencies[tile] > 0 ? frequencies[tile] : kRare;
}

double entropy(const TileMask& tiles, const std::vector<double>& frequencies) {
  double sum = 0, logs = 0;
  tiles.for_each([&](Tile tile) {
    const double weight = weight_of(frequencies, tile);
    sum += weight;
    logs += weight * std::log(weight);
  });
  return sum > 0 ? std::log(sum) - logs / sum : 0;
}

/// Gives places in the order of their entropy.
class Entropies {
 public:
  Entropies(Block& block, RandomStream& random) : block_(block), now_(block.size()) {
    // Places of equal entropy come in a random order.
    for (std::size_t place = 0; place < block.size(); ++place) noise_.push_back(1e-6 * uniform(random));
    for (std::uint32_t place = 0; place < block.size(); ++place) look_at(place);
  }

  /// Returns the place with the least entropy of those with several tiles, or the block's size.
  std::size_t least() {
    for (const std::uint32_t place : block_.take_touched()) look_at(place);
    while (!queue_.empty()) {
      const auto [value, place] = queue_.top();
      queue_.pop();
      if (value == now_[place] && block_.domain(place).size() > 1) return place;
    }
    return block_.size();
  }

 private:
  using Entry = std::pair<double, std::uint32_t>;

  /// Puts a place into the queue with the entropy that it has now. What was there before is out of date.
  void look_at(std::uint32_t place) {
    const TileMask& tiles = block_.domain(place);
    if (tiles.size() < 2) return;
    const auto& frequencies = block_.problem().style().frequencies[block_.zone(place)];
    now_[place] = entropy(tiles, frequencies) + noise_[place];
    queue_.emplace(now_[place], place);
  }

  Block& block_;
  std::vector<double> now_, noise_;  // by place
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
};

}  // namespace

Tile draw_tile(const TileMask& tiles, const std::vector<double>& frequencies, RandomStream& random) {
  double sum = 0;
  tiles.for_each([&](Tile tile) { sum += weight_of(frequencies, tile); });
  double left = uniform(random) * sum;
  Tile drawn = tiles.lowest();
  bool found = false;
  tiles.for_each([&](Tile tile) {
    if (found) return;
    drawn = tile;
    left -= weight_of(frequencies, tile);
    found = left < 0;
  });
  return drawn;
}

Outcome collapse(Block& block, RandomStream& random, const StopSignal& stop, CollapseOrder order) {
  if (!block.propagate()) return Outcome::kGaveUp;
  Entropies entropies(block, random);
  std::size_t read = 0;
  const auto next = [&] {
    if (order == CollapseOrder::kLeastEntropy) return entropies.least();
    while (read < block.size() && block.domain(read).size() == 1) ++read;
    return read;
  };
  std::size_t chosen = 0;
  for (std::size_t place = next(); place < block.size(); place = next()) {
    if (++chosen % 256 == 0 && stop.stopped()) return Outcome::kStopped;
    const auto& frequencies = block.problem().style().frequencies[block.zone(place)];
    block.restrict(place, TileMask::of(draw_tile(block.domain(place), frequencies, random)));
    if (!block.propagate()) return Outcome::kGaveUp;
  }
  return Outcome::kFound;
}

}  // namespace solitaire::tiles
