#include "base/hash.h"
#include "engines/tiles/sample/sampler.h"
#include "engines/tiles/start/collapse.h"

namespace solitaire::tiles {
namespace {

constexpr std::uint64_t kAttempts = 20;

/// Collapses the whole map, again and again until it comes out without an empty site.
Sample sample_collapse(const Problem& problem, const std::vector<TileMask>& domains,
                       const SamplerOptions& options, std::uint64_t number, const StopSignal& stop) {
  Sample sample;
  const Block block(problem, domains, Grid(problem.size()), whole_box(problem.size()));
  const CollapseOrder order =
      options.kind == SamplerKind::kRaster ? CollapseOrder::kReading : CollapseOrder::kLeastEntropy;
  const std::uint64_t most = options.effort > 0 ? options.effort : kAttempts;
  RandomStream random(mix(options.seed, number), Purpose::kTiles, UINT64_MAX);
  do {
    Block tried = block;
    ++sample.windows;
    sample.outcome = collapse(tried, random, stop, order);
    if (sample.outcome != Outcome::kFound) continue;
    sample.map = Grid(problem.size());
    tried.write_to(sample.map);
  } while (sample.outcome == Outcome::kGaveUp && sample.windows < most);
  return sample;
}

Sample sample_search(const Problem& problem, const std::vector<TileMask>& domains,
                     const SamplerOptions& options, std::uint64_t number, const StopSignal& stop) {
  Sample sample;
  RandomStream random(mix(options.seed, number), Purpose::kTiles, UINT64_MAX);
  sample.outcome = solve_whole(problem, domains, random, stop, sample.map);
  return sample;
}

Sample sample_pairs(const Problem& problem, const std::vector<TileMask>& domains,
                    const SamplerOptions& options, std::uint64_t number, const StopSignal& stop) {
  switch (options.kind) {
    case SamplerKind::kWindows:
      return sample_windows(problem, domains, options, number, stop);
    case SamplerKind::kBlockSs:
      return sample_blockss(problem, options, number, stop);
    case SamplerKind::kWfc:
    case SamplerKind::kRaster:
      return sample_collapse(problem, domains, options, number, stop);
    case SamplerKind::kMh:
    case SamplerKind::kGibbs:
      return sample_sites(problem, options, number, stop);
    case SamplerKind::kSearch:
      return sample_search(problem, domains, options, number, stop);
  }
  return {};
}

}  // namespace

Sample draw_sample(const Problem& problem, const std::vector<TileMask>& domains,
                   const SamplerOptions& options, std::uint64_t number, const StopSignal& stop) {
  Sample sample;
  if (domains.empty()) {
    sample.outcome = Outcome::kNone;
    return sample;
  }
  sample = sample_pairs(problem, domains, options, number, stop);
  // Only windows know of global rules; what another sampler made may break one.
  if (sample.outcome == Outcome::kFound && problem.violation(sample.map) > 0)
    sample.outcome = Outcome::kGaveUp;
  return sample;
}

}  // namespace solitaire::tiles
