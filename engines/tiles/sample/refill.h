#pragma once
#include "engines/tiles/sample/sampler.h"

namespace solitaire::tiles {

/// Makes a part of a map anew: the sites of a box, by windows; the others stay. The work depends on the size
/// of the box alone, so that somebody who paints on a large map does not wait. `map` keeps all rules about
/// pairs outside of the box; it is left as it is unless the outcome is kFound.
///
/// For problems without global rules and without rings. Throws std::invalid_argument for others.
Outcome refill(const Problem& problem, const Box& box, const SamplerOptions& options, const StopSignal& stop,
               Grid& map);

}  // namespace solitaire::tiles
