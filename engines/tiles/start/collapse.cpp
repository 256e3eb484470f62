#include "engines/tiles/start/collapse.h"

#include <cmath>
#include <limits>

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

/// Knows the entropy of every place, each as of the domain that it was found for.
class Entropies {
 public:
  Entropies(const Block& block, RandomStream& random)
      : block_(block), known_(block.size()), values_(block.size()) {
    // Places of equal entropy come in a random order.
    for (std::size_t place = 0; place < block.size(); ++place) noise_.push_back(1e-6 * uniform(random));
  }

  /// Returns the place with the least entropy of those with several tiles, or the block's size.
  std::size_t least() {
    std::size_t best = block_.size();
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t place = 0; place < block_.size(); ++place) {
      const double value = of(place);
      if (value < least && block_.domain(place).size() > 1) {
        least = value;
        best = place;
      }
    }
    return best;
  }

 private:
  double of(std::size_t place) {
    const TileMask& tiles = block_.domain(place);
    if (!(known_[place] == tiles)) {
      known_[place] = tiles;
      values_[place] = tiles.size() < 2 ? std::numeric_limits<double>::infinity()
                                        : entropy(tiles, frequencies(place)) + noise_[place];
    }
    return values_[place];
  }
  const std::vector<double>& frequencies(std::size_t place) const {
    return block_.problem().style().frequencies[block_.zone(place)];
  }

  const Block& block_;
  std::vector<TileMask> known_;
  std::vector<double> values_, noise_;
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

bool collapse(Block& block, RandomStream& random, CollapseOrder order) {
  Entropies entropies(block, random);
  std::size_t read = 0;
  const auto next = [&] {
    if (order == CollapseOrder::kLeastEntropy) return entropies.least();
    while (read < block.size() && block.domain(read).size() == 1) ++read;
    return read;
  };
  if (!block.propagate()) return false;
  for (std::size_t place = next(); place < block.size(); place = next()) {
    const auto& frequencies = block.problem().style().frequencies[block.zone(place)];
    block.restrict(place, TileMask::of(draw_tile(block.domain(place), frequencies, random)));
    if (!block.propagate()) return false;
  }
  return true;
}

}  // namespace solitaire::tiles
