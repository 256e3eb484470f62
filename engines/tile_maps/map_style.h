#pragma once
#include <memory>

#include "base/stop_signal.h"
#include "engines/tiles/model/style.h"
#include "solitaire/names/program.h"
#include "solitaire/value/value.h"

namespace solitaire {

/// Returns what an exemplar says, as the `source` of a set of tiles (std/tiles.sol) names it: rows of
/// numbers, or a file. The tiles have the numbers that they have in the set. Weights are fitted where there
/// is an exemplar. Throws Interrupted.
std::shared_ptr<const tiles::Style> style_of_source(const Value& source, const Program& program,
                                                    std::uint64_t seed, const StopSignal& stop);

}  // namespace solitaire
