#include "engines/tiles/model/pair_rules.h"

namespace solitaire::tiles {

PairRules::PairRules(std::size_t tiles) {
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    next_[axis].resize(tiles);
    previous_[axis].resize(tiles);
  }
}

void PairRules::allow(std::size_t axis, Tile first, Tile second) {
  next_[axis][first].insert(second);
  previous_[axis][second].insert(first);
}

void PairRules::forbid(std::size_t axis, Tile first, Tile second) {
  next_[axis][first].erase(second);
  previous_[axis][second].erase(first);
}

TileMask PairRules::beside_any(const TileMask& tiles, std::size_t axis, int step) const {
  TileMask result;
  tiles.for_each([&](Tile tile) { result |= beside(tile, axis, step); });
  return result;
}

void PairRules::unite(const PairRules& other) {
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    for (std::size_t tile = 0; tile < next_[axis].size(); ++tile) {
      next_[axis][tile] |= other.next_[axis][tile];
      previous_[axis][tile] |= other.previous_[axis][tile];
    }
  }
}

}  // namespace solitaire::tiles
