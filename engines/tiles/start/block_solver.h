#pragma once
#include "base/random.h"
#include "base/stop_signal.h"
#include "engines/tiles/start/block.h"
#include "engines/tiles/start/outcome.h"

namespace solitaire::tiles {

/// Chooses a block's tiles by CaDiCaL, which first tries tiles that are as frequent as in the exemplars.
/// kNone is a proof that there are no such tiles.
///
/// A variable stands for each place and tile of its domain; exactly one of a place holds. A tile implies that
/// one of its partners is at each neighbour (support clauses; Gent 2002), unless it goes with all of them.
Outcome solve_block(Block& block, RandomStream& random, const StopSignal& stop);

}  // namespace solitaire::tiles
