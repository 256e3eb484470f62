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

}  // namespace

void add_pairs_of_matching_icons(double tolerance, Style& style) {
  const Tileset& tileset = style.tileset;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    std::vector<std::vector<Rgba>> firsts, lasts;  // sides, by tile
    for (std::size_t tile = 0; tile < tileset.size(); ++tile) {
      const TileKind& kind = tileset[static_cast<Tile>(tile)];
      if (kind.icon.empty())
        throw RequestError(fmt::format("'{}' has no picture whose sides could be compared", kind.name));
      firsts.push_back(side_of(kind.icon, axis, false));
      lasts.push_back(side_of(kind.icon, axis, true));
    }
    for (std::size_t tile = 0; tile < tileset.size(); ++tile) {
      ListedPairs pairs{axis, TileMask::of(static_cast<Tile>(tile)), {}};
      for (std::size_t next = 0; next < tileset.size(); ++next) {
        if (difference(lasts[tile], firsts[next]) <= tolerance) pairs.second.insert(static_cast<Tile>(next));
      }
      if (!pairs.second.empty()) style.listed.push_back(pairs);
    }
  }
}

}  // namespace solitaire::tiles
