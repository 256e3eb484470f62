#include "engines/tiles/rules/tile_count.h"

namespace solitaire::tiles {

std::uint64_t TileCount::violation(const Grid& map) const {
  std::uint64_t count = 0;
  for (const Tile tile : map.tiles) count += tiles_.contains(tile) ? 1 : 0;
  if (count < least_) return least_ - count;
  return count > most_ ? count - most_ : 0;
}

}  // namespace solitaire::tiles
