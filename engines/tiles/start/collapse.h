#pragma once
#include "base/random.h"
#include "base/stop_signal.h"
#include "engines/tiles/start/block.h"
#include "engines/tiles/start/outcome.h"

namespace solitaire::tiles {

/// Which place gets its tile next.
enum class CollapseOrder : std::uint8_t {
  kLeastEntropy,  // the one about which most is known
  kReading,       // the first that has several tiles left
};

/// Chooses the tiles of a block as WaveFunctionCollapse does (Gumin 2016): again and again a tile for a
/// place, as frequent as in the exemplars, and what follows for its neighbours. Gives up where it comes to a
/// place without a tile; the block is then useless.
Outcome collapse(Block& block, RandomStream& random, const StopSignal& stop,
                 CollapseOrder order = CollapseOrder::kLeastEntropy);

/// Draws a tile of a set that is not empty, as frequent as in the exemplars of a zone.
Tile draw_tile(const TileMask& tiles, const std::vector<double>& frequencies, RandomStream& random);

}  // namespace solitaire::tiles
