#pragma once
#include <array>
#include <vector>

#include "engines/tiles/model/tile_mask.h"

namespace solitaire::tiles {

/// Which tiles may follow each other along each axis: the hard rules.
class PairRules {
 public:
  explicit PairRules(std::size_t tiles = 0);

  /// From now on `second` may be the next tile after `first` along the axis.
  void allow(std::size_t axis, Tile first, Tile second);
  void forbid(std::size_t axis, Tile first, Tile second);
  bool allowed(std::size_t axis, Tile first, Tile second) const {
    return next_[axis][first].contains(second);
  }
  /// Returns the tiles that may be beside `tile` along the axis: behind it for step 1, before it for -1.
  const TileMask& beside(Tile tile, std::size_t axis, int step) const {
    return (step > 0 ? next_ : previous_)[axis][tile];
  }
  /// Returns the tiles that may be beside some tile of a set.
  TileMask beside_any(const TileMask& tiles, std::size_t axis, int step) const;
  /// Allows what the other rules allow, too.
  void unite(const PairRules& other);

 private:
  using Table = std::array<std::vector<TileMask>, kAxes>;
  Table next_, previous_;
};

}  // namespace solitaire::tiles
