#pragma once
#include "base/random.h"
#include "engines/tiles/start/block.h"

namespace solitaire::tiles {

/// Which place gets its tile next.
enum class CollapseOrder : std::uint8_t {
  kLeastEntropy,  // the one about which most is known
  kReading,       // the first that has several tiles left
};

/// Chooses the tiles of a block as WaveFunctionCollapse does (Gumin 2016): again and again a tile for a
/// place, as frequent as in the exemplars, and what follows for its neighbours. Returns false if it came to a
/// place without a tile; the block is then useless.
bool collapse(Block& block, RandomStream& random, CollapseOrder order = CollapseOrder::kLeastEntropy);

/// Draws a tile of a set that is not empty, as frequent as in the exemplars of a zone.
Tile draw_tile(const TileMask& tiles, const std::vector<double>& frequencies, RandomStream& random);

}  // namespace solitaire::tiles
