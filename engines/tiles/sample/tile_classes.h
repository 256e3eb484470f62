#pragma once
#include <cstddef>
#include <vector>

#include "engines/tiles/model/style.h"
#include "engines/tiles/model/tileset.h"

namespace solitaire::tiles {

/// Says which tiles are all the same to their neighbours on some sides: those beside which the same tiles may
/// stand there, as all tiles with rails to the right. Zones have pairs of their own, so that where there are
/// several, no two tiles are the same.
class TileClasses {
 public:
  explicit TileClasses(const Style& style) : style_(style), by_sides_(kAllSides + 1) {}

  /// Returns, by tile, the first of those that are the same on all of these sides; null where no two are.
  const Tile* of(Sides sides);
  /// Returns how many classes there are.
  std::size_t count(Sides sides);

 private:
  struct Classes {
    std::vector<Tile> first;  // by tile
    std::size_t count = 0;
  };

  const Classes& classes(Sides sides);
  bool are_same(Tile a, Tile b, Sides sides) const;

  const Style& style_;
  std::vector<Classes> by_sides_;  // filled in when they are first asked for
};

}  // namespace solitaire::tiles
