#include "engines/tiles/sample/tile_classes.h"

namespace solitaire::tiles {

const Tile* TileClasses::of(Sides sides) {
  const Classes& found = classes(sides);
  return found.count == found.first.size() ? nullptr : found.first.data();
}

std::size_t TileClasses::count(Sides sides) { return classes(sides).count; }

const TileClasses::Classes& TileClasses::classes(Sides sides) {
  Classes& made = by_sides_[sides];
  if (!made.first.empty()) return made;
  for (std::size_t number = 0; number < style_.tileset.size(); ++number) {
    const auto tile = static_cast<Tile>(number);
    Tile first = 0;
    while (first != tile && (made.first[first] != first || !are_same(first, tile, sides))) ++first;
    made.first.push_back(first);
    if (first == tile) ++made.count;
  }
  return made;
}

bool TileClasses::are_same(Tile a, Tile b, Sides sides) const {
  if (style_.zones > 1) return false;
  const PairRules& pairs = style_.pairs.front();
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    for (const int step : {1, -1}) {
      if ((sides & side(axis, step)) != 0 && pairs.beside(a, axis, step) != pairs.beside(b, axis, step))
        return false;
    }
  }
  return true;
}

}  // namespace solitaire::tiles
