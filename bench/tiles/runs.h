#pragma once
#include <vector>

#include "engines/tiles/sample/sampler.h"

namespace solitaire::tiles::bench {

/// What several maps of one kind took.
struct Runs {
  std::vector<Grid> maps;
  std::size_t tried = 0;
  double seconds = 0;  // of the processor, on all attempts

  double seconds_each() const { return seconds / static_cast<double>(tried); }
};

/// Returns the seconds of the processor that this process has taken.
double processor_seconds();

/// Draws maps with the numbers from 1 on, each of which may take so many seconds of the
/// processor.
Runs run(const Problem& problem, const SamplerOptions& options, std::size_t maps, double limit = 60);

/// Options of a sampler of that kind.
SamplerOptions options_of(SamplerKind kind, std::uint64_t burn_in = 0, int blocks = 6);

}  // namespace solitaire::tiles::bench
