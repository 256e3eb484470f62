#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "base/stop_signal.h"
#include "engines/tiles/sample/sampler_options.h"
#include "engines/tiles/start/start.h"

namespace solitaire::tiles {

/// What a sampler made, and what it took.
struct Sample {
  Outcome outcome = Outcome::kStopped;
  Grid map;
  std::uint64_t sweeps = 0;   // windows: of the map
  std::uint64_t windows = 0;  // windows that were redrawn, or steps of the other samplers
  std::uint64_t left = 0;     // sites left as they were: too many states even for one alone
  std::uint64_t refused = 0;  // windows put back: they would have broken a global rule
};

/// Makes the map with a number. The result depends on the problem, the options and the number alone.
/// `domains` are consistent_domains(). All but windows and search may give up where there is a map.
Sample draw_sample(const Problem& problem, const std::vector<TileMask>& domains,
                   const SamplerOptions& options, std::uint64_t number, const StopSignal& stop);

/// By windows: a start that keeps all pairs, then sweeps of redrawn windows.
///
/// Without global rules every window is drawn exactly, so that the distribution of the problem is invariant.
/// With them a window that breaks one is put back (Metropolis and Hastings with probabilities 0 and 1). Until
/// the rules hold for the first time, windows that come nearer to that are favoured.
Sample sample_windows(const Problem& problem, const std::vector<TileMask>& domains,
                      const SamplerOptions& options, std::uint64_t number, const StopSignal& stop);

/// The same, beginning with a map that keeps all rules.
Sample redraw_map(const Problem& problem, const std::vector<TileMask>& domains, const SamplerOptions& options,
                  std::uint64_t number, const StopSignal& stop, const Grid& start);

/// By block search (the paper's algorithms 1 and 2).
Sample sample_blockss(const Problem& problem, const SamplerOptions& options, std::uint64_t number,
                      const StopSignal& stop);

/// Single-site chains from random tiles until no pair is broken.
Sample sample_sites(const Problem& problem, const SamplerOptions& options, std::uint64_t number,
                    const StopSignal& stop);

}  // namespace solitaire::tiles
