#include "engines/tiles/request/tile_images.h"

#include <algorithm>

#include "engines/tiles/request/names.h"
#include "engines/tiles/request/tile_variants.h"

namespace solitaire::tiles {
namespace {

bool has_labels(const TileKind& kind) {
  return std::ranges::any_of(kind.edges, [](const std::string& label) { return !label.empty(); });
}

bool has_same_voxels(const TileKind& one, const TileKind& other) {
  if (!one.voxels || !other.voxels) return one.voxels == other.voxels;
  return *one.voxels == *other.voxels;
}

bool looks_like(const TileKind& one, const TileKind& other) {
  return one.icon == other.icon && one.edges == other.edges && one.color == other.color &&
         one.asset == other.asset && (one.asset.empty() || one.turn == other.turn) &&
         has_same_voxels(one, other);
}

}  // namespace

std::optional<Tile> TileImages::image(Tile tile, const Symmetry& symmetry) {
  std::optional<Tile> now = tile;
  if (symmetry.mirrored) now = mirrored(*now);
  for (int turn = 0; turn < symmetry.turns && now; ++turn) now = turned(*now);
  return now;
}

std::optional<Tile> TileImages::turned(Tile tile) {
  const TileKind& kind = tileset_[tile];
  if (!kind.turned.empty()) return tile_called(tileset_, kind.turned);
  return like(tile, turned_kind(kind));
}

std::optional<Tile> TileImages::mirrored(Tile tile) {
  const TileKind& kind = tileset_[tile];
  if (!kind.mirrored.empty()) return tile_called(tileset_, kind.mirrored);
  return like(tile, mirrored_kind(kind));
}

/// Returns the tile that looks as wanted: the image of `tile`.
std::optional<Tile> TileImages::like(Tile tile, TileKind wanted) {
  const TileKind& kind = tileset_[tile];
  if (!kind.rotates || unknown_ == UnknownImages::kNothing) return std::nullopt;
  if (kind.voxel || (kind.gid && kind.parts.empty()) || unknown_ == UnknownImages::kItself) return tile;
  if (kind.gid) {
    const auto known = tileset_.find(wanted.name);
    return known ? *known : tileset_.add(std::move(wanted));
  }
  if (kind.icon.empty() && !has_labels(kind)) return std::nullopt;
  if (looks_like(kind, wanted)) return tile;
  for (std::size_t other = 0; other < tileset_.size(); ++other) {
    if (looks_like(tileset_[static_cast<Tile>(other)], wanted)) return static_cast<Tile>(other);
  }
  return std::nullopt;
}

}  // namespace solitaire::tiles
