#include "engines/tiles/request/matching_icons.h"

#include <cstdlib>
#include <fmt/format.h>

#include "engines/tiles/request/request_error.h"

namespace solitaire::tiles {
namespace {

/// Returns the pixels of an icon along its first or its last side across an axis.
std::vector<Rgba> side_of(const Picture& icon, std::size_t axis, bool last) {
  const int length = axis == 0 ? icon.height : icon.width;
  const int across = last ? (axis == 0 ? icon.width : icon.height) - 1 : 0;
  std::vector<Rgba> pixels;
  for (int at = 0; at < length; ++at) pixels.push_back(axis == 0 ? icon.at(across, at) : icon.at(at, across));
  return pixels;
}

/// Returns the mean difference of all channels, from 0 to 1.
double difference(const std::vector<Rgba>& a, const std::vector<Rgba>& b) {
  int sum = 0;
  for (std::size_t pixel = 0; pixel < a.size(); ++pixel) {
    for (std::size_t channel = 0; channel < 4; ++channel)
      sum += std::abs(a[pixel][channel] - b[pixel][channel]);
  }
  return sum / (4.0 * 255.0 * static_cast<double>(a.size()));
}

/// The same for layers of voxels: the share of places where these differ.
double difference(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
  int count = 0;
  for (std::size_t voxel = 0; voxel < a.size(); ++voxel) count += a[voxel] == b[voxel] ? 0 : 1;
  return count / static_cast<double>(a.size());
}

/// Adds the pairs along an axis whose sides, which `side_of(kind, last)` returns, differ by no more.
template <class SideOf>
void add_pairs_along(std::size_t axis, double tolerance, SideOf side_of, Style& style) {
  const Tileset& tileset = style.tileset;
  std::vector<decltype(side_of(tileset[0], false))> firsts, lasts;  // by tile
  for (std::size_t tile = 0; tile < tileset.size(); ++tile) {
    firsts.push_back(side_of(tileset[static_cast<Tile>(tile)], false));
    lasts.push_back(side_of(tileset[static_cast<Tile>(tile)], true));
  }
  for (std::size_t tile = 0; tile < tileset.size(); ++tile) {
    ListedPairs pairs{axis, TileMask::of(static_cast<Tile>(tile)), {}};
    for (std::size_t next = 0; next < tileset.size(); ++next) {
      if (difference(lasts[tile], firsts[next]) <= tolerance) pairs.second.insert(static_cast<Tile>(next));
    }
    if (!pairs.second.empty()) style.listed.push_back(pairs);
  }
}

}  // namespace

void add_pairs_of_matching_icons(double tolerance, Style& style) {
  bool all_have_models = true;
  for (std::size_t tile = 0; tile < style.tileset.size(); ++tile) {
    const TileKind& kind = style.tileset[static_cast<Tile>(tile)];
    if (kind.icon.empty())
      throw RequestError(fmt::format("'{}' has no picture whose sides could be compared", kind.name));
    all_have_models = all_have_models && kind.voxels;
  }
  if (all_have_models) {
    for (std::size_t axis = 0; axis < kAxes; ++axis)
      add_pairs_along(
          axis, tolerance,
          [axis](const TileKind& kind, bool last) { return layer_of(*kind.voxels, axis, last); }, style);
    return;
  }
  for (std::size_t axis = 0; axis < 2; ++axis)
    add_pairs_along(
        axis, tolerance, [axis](const TileKind& kind, bool last) { return side_of(kind.icon, axis, last); },
        style);
}

}  // namespace solitaire::tiles
