#include <algorithm>
#include <cmath>

#include "base/hash.h"
#include "engines/tiles/model/uniform.h"
#include "engines/tiles/sample/local_score.h"
#include "engines/tiles/sample/sampler.h"

namespace solitaire::tiles {
namespace {

const double kLogBroken = std::log(1e-8);                // as in the paper's section 8.2
constexpr std::uint64_t kStepsBeforeGivingUp = 200'000;  // before it gives up

/// A chain that changes one site at a time.
class SiteChain {
 public:
  SiteChain(const Problem& problem, const SamplerOptions& options, std::uint64_t number)
      : problem_(problem),
        gibbs_(options.kind == SamplerKind::kGibbs),
        score_(problem, kLogBroken),
        random_(mix(options.seed, number), Purpose::kTiles, UINT64_MAX),
        map_(problem.size()) {
    for (std::size_t site = 0; site < map_.tiles.size(); ++site) map_[site] = any_tile(problem.domain(site));
    for (std::size_t site = 0; site < map_.tiles.size(); ++site) broken_ += score_.broken_at(map_, site);
  }

  /// Twice the number of broken pairs.
  std::size_t broken() const { return broken_; }
  Grid take_map() { return std::move(map_); }

  void step() {
    const std::size_t site = random_.below(map_.tiles.size());
    const Tile before = map_[site];
    const std::size_t broken_before = score_.broken_at(map_, site);
    gibbs_ ? redraw(site) : propose(site);
    if (map_[site] != before) broken_ += 2 * score_.broken_at(map_, site) - 2 * broken_before;
  }

 private:
  Tile any_tile(const TileMask& tiles) {
    std::uint64_t left = random_.below(tiles.size());
    Tile result = tiles.lowest();
    tiles.for_each([&](Tile tile) {
      if (left-- == 0) result = tile;
    });
    return result;
  }

  void propose(std::size_t site) {
    const Tile before = map_[site];
    const double score = score_.at(map_, site);
    map_[site] = any_tile(problem_.domain(site));
    if (uniform(random_) >= std::exp(score_.at(map_, site) - score)) map_[site] = before;
  }

  void redraw(std::size_t site) {
    std::vector<std::pair<Tile, double>> weights;
    double most = -INFINITY, sum = 0;
    problem_.domain(site).for_each([&](Tile tile) {
      map_[site] = tile;
      weights.emplace_back(tile, score_.at(map_, site));
      most = std::max(most, weights.back().second);
    });
    for (auto& [tile, weight] : weights) sum += weight = std::exp(weight - most);
    double left = uniform(random_) * sum;
    for (const auto& [tile, weight] : weights) {
      map_[site] = tile;
      left -= weight;
      if (left < 0) return;
    }
  }

  const Problem& problem_;
  bool gibbs_;
  LocalScore score_;
  RandomStream random_;
  Grid map_;
  std::size_t broken_ = 0;
};

}  // namespace

Sample sample_sites(const Problem& problem, const SamplerOptions& options, std::uint64_t number,
                    const StopSignal& stop) {
  Sample sample;
  SiteChain chain(problem, options, number);
  const std::uint64_t most = options.effort > 0 ? options.effort : kStepsBeforeGivingUp * problem.sites();
  while (chain.broken() > 0 && sample.windows < most) {
    if (sample.windows % 1024 == 0 && stop.stopped()) return sample;
    chain.step();
    ++sample.windows;
  }
  sample.outcome = chain.broken() == 0 ? Outcome::kFound : Outcome::kGaveUp;
  sample.map = chain.take_map();
  return sample;
}

}  // namespace solitaire::tiles
