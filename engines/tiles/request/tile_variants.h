#pragma once
#include <string>
#include <vector>

#include "engines/tiles/model/tileset.h"

namespace solitaire::tiles {

/// Returns the tile turned by a quarter, clockwise: what was on top is at the right. Its name changes only if
/// it is a tile of Tiled.
TileKind turned_kind(const TileKind& kind);
/// The same for its mirror image, left to right.
TileKind mirrored_kind(const TileKind& kind);

/// Returns a tile with those of its turned and mirrored images that differ from it, as the letter of its
/// symmetry says: X has none, I and \ have one, T and L have four turns, F has also the mirror images of
/// these. They are named after the quarter turns, clockwise: "bend", "bend!90", "bend!180", "bend!270", and
/// "bend!x", "bend!x90" for those mirrored left to right before they are turned. Icons, labels of sides and
/// models turn along. Throws RequestError for other letters, and where a model would have to be mirrored.
std::vector<TileKind> variants_of(const TileKind& kind, const std::string& symmetry);

}  // namespace solitaire::tiles
