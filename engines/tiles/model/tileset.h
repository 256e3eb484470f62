#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engines/tiles/model/grid.h"
#include "engines/tiles/model/picture.h"
#include "engines/tiles/model/voxel_model.h"

namespace solitaire::tiles {

/// The sides of a tile that can be open: towards +x, -x, +y, -y, +z and -z, as bits in this order.
using Sides = std::uint8_t;
inline constexpr Sides kAllSides = 0x3f;
inline constexpr Sides kFlatSides = 0x0f;  // those along x and y
constexpr std::size_t side_number(std::size_t axis, int step) { return 2 * axis + (step > 0 ? 0 : 1); }
constexpr Sides side(std::size_t axis, int step) { return static_cast<Sides>(1U << side_number(axis, step)); }

/// A tile of one layer of a map of Tiled.
struct TiledPart {
  std::uint32_t gid = 0;  // with its flags; 0 where the layer has no tile
  std::string name;       // without what says how it is turned
};

/// A kind of tile.
struct TileKind {
  std::string name;  // unique in its tileset
  std::string text;  // the character of text maps
  Rgba color{};      // of maps that give a pixel to a tile
  Picture icon;      // empty: a plain square of the colour
  std::optional<std::uint32_t>
      gid;                       // in the lowest layer of the Tiled map that it was read from, with its flags
  std::vector<TiledPart> parts;  // by visible layer of that map, from below
  double bias = 1;               // multiplies the weight of each occurrence
  std::optional<std::uint8_t> voxel;         // its colour's number in .vox models; 0 is empty
  std::shared_ptr<const VoxelModel> voxels;  // its own model, as large as those of the other tiles; or none
  std::string asset;                         // the model that scenes show; empty: a box of the colour
  int turn = 0;                              // quarter turns of the model, counter-clockwise seen from above
  /// The labels of its sides in the order of Sides, read clockwise; without any it has none. Two tiles may be
  /// beside each other where their sides have labels that meet.
  std::array<std::string, 2 * kAxes> edges;
  double height = 1;    // of the box, in sides of a tile; 0: scenes show nothing
  bool rotates = true;  // else exemplars that are turned or mirrored have a hole in its place
  /// The name of the tile that it is after a quarter turn, clockwise, and of its mirror image, left to right;
  /// empty: the one that looks so.
  std::string turned = "", mirrored = "";
};

/// Returns a tile that shows nothing.
TileKind empty_kind(const std::string& name);

/// The tiles of a style, at most kMostTiles.
class Tileset {
 public:
  std::size_t size() const { return kinds_.size(); }
  const TileKind& operator[](Tile tile) const { return kinds_[tile]; }
  TileKind& operator[](Tile tile) { return kinds_[tile]; }
  /// Adds a kind of tile. Throws std::length_error if there are too many.
  Tile add(TileKind kind);
  /// Returns the tile of that name.
  std::optional<Tile> find(std::string_view name) const;
  std::vector<std::string> names() const;

 private:
  std::vector<TileKind> kinds_;
};

}  // namespace solitaire::tiles
