#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace solitaire::tiles {

/// The number of a tile in its Tileset.
using Tile = std::uint8_t;
/// Stands in a grid where no tile is. Nothing is learned from a hole.
inline constexpr Tile kHole = 255;
inline constexpr std::size_t kMostTiles = 255;
/// The most sites that a grid may have. What is known of a site takes about 100 bytes at the most.
inline constexpr std::size_t kMostSites = std::size_t{1} << 22;

/// The axes: x to the right, y down the page, z from one layer to the next.
inline constexpr int kAxes = 3;

/// A place of a grid, or a distance between two places. Indexed by axis.
using Point = std::array<int, kAxes>;

/// How far a grid or a patch extends along each axis; at least 1.
struct Size {
  Point extent{1, 1, 1};

  int width() const { return extent[0]; }
  int height() const { return extent[1]; }
  int depth() const { return extent[2]; }
  std::size_t volume() const {
    return static_cast<std::size_t>(extent[0]) * static_cast<std::size_t>(extent[1]) *
           static_cast<std::size_t>(extent[2]);
  }
  /// Returns the number of a site: along x first, then y, then z.
  std::size_t site(const Point& at) const {
    return static_cast<std::size_t>(at[0]) +
           static_cast<std::size_t>(extent[0]) *
               (static_cast<std::size_t>(at[1]) +
                static_cast<std::size_t>(extent[1]) * static_cast<std::size_t>(at[2]));
  }
  Point point(std::size_t site) const {
    const auto w = static_cast<std::size_t>(extent[0]), h = static_cast<std::size_t>(extent[1]);
    return {static_cast<int>(site % w), static_cast<int>(site / w % h), static_cast<int>(site / w / h)};
  }
  /// Returns a place of which numbers below 0 are counted from the far side: -1 is the last one.
  Point counted(Point at) const {
    for (std::size_t axis = 0; axis < kAxes; ++axis) at[axis] += at[axis] < 0 ? extent[axis] : 0;
    return at;
  }
  friend bool operator==(const Size&, const Size&) = default;
};

/// Returns "4x3", or "4x3x2" if there are layers.
inline std::string size_text(const Size& size) {
  const std::string flat = std::to_string(size.width()) + "x" + std::to_string(size.height());
  return size.depth() > 1 ? flat + "x" + std::to_string(size.depth()) : flat;
}

/// A tile, or a hole, at every site.
struct Grid {
  Size size;
  std::vector<Tile> tiles;

  Grid() : tiles(1, kHole) {}
  explicit Grid(Size of, Tile fill = kHole) : size(of), tiles(of.volume(), fill) {}

  Tile& operator[](std::size_t site) { return tiles[site]; }
  Tile operator[](std::size_t site) const { return tiles[site]; }
  Tile at(const Point& at) const { return tiles[size.site(at)]; }
  friend bool operator==(const Grid&, const Grid&) = default;
};

/// Which sites are neighbours: those of a box whose periodic axes are closed to rings.
struct Topology {
  static constexpr std::size_t kNone = SIZE_MAX;

  Size size;
  std::array<bool, kAxes> periodic{};

  /// Moves a place by a distance. Returns false beyond the border of an axis that is not periodic.
  bool move(Point& place, const Point& distance) const {
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      int& at = place[axis];
      at += distance[axis];
      const int extent = size.extent[axis];
      if (at >= 0 && at < extent) continue;
      if (!periodic[axis]) return false;
      at = ((at % extent) + extent) % extent;
    }
    return true;
  }
  /// Returns the site at a distance from a place, or kNone beyond the border of an axis that is not periodic.
  std::size_t site(Point from, const Point& distance) const {
    return move(from, distance) ? size.site(from) : kNone;
  }
  /// Returns the next site along an axis: step is 1 or -1.
  std::size_t neighbor(const Point& from, std::size_t axis, int step) const {
    Point distance{};
    distance[axis] = step;
    return site(from, distance);
  }
};

/// Calls `visit(point)` for every point of a box, in the order of site numbers.
template <class Visit>
void for_each_point(const Size& size, Visit visit) {
  for (int z = 0; z < size.depth(); ++z) {
    for (int y = 0; y < size.height(); ++y) {
      for (int x = 0; x < size.width(); ++x) visit(Point{x, y, z});
    }
  }
}

}  // namespace solitaire::tiles
