#pragma once
#include <optional>

#include "engines/tiles/model/symmetry.h"
#include "engines/tiles/model/tileset.h"
#include "engines/tiles/request/request.h"

namespace solitaire::tiles {

/// Knows what tiles become when the map that they are in is turned or mirrored: what their author says, or
/// else the tile whose icon and labels of sides are theirs, turned. A tile of a map of Tiled gets a turned
/// one of its own. Voxels and tiles of a plain colour stay what they are.
class TileImages {
 public:
  /// Tiles of Tiled are added to the tileset when they are asked for.
  TileImages(Tileset& tileset, UnknownImages unknown) : tileset_(tileset), unknown_(unknown) {}

  /// Returns the tile's image; nothing for a tile that has none, or of which nothing is known.
  std::optional<Tile> image(Tile tile, const Symmetry& symmetry);

 private:
  std::optional<Tile> turned(Tile tile);
  std::optional<Tile> mirrored(Tile tile);
  std::optional<Tile> like(Tile tile, TileKind wanted);

  Tileset& tileset_;
  UnknownImages unknown_;
};

}  // namespace solitaire::tiles
