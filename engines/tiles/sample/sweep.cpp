#include "engines/tiles/sample/sweep.h"

#include <algorithm>
#include <cmath>

#include "engines/tiles/sample/tile_classes.h"

namespace solitaire::tiles {
namespace {

/// Longer bands are cut, so that the memory for a window stays small.
constexpr int kLongestBand = 256;
constexpr std::uint64_t kThickEvery = 4;
/// Bands are three sites high where so few columns of three tiles are allowed, else two.
constexpr std::size_t kMostColumns = 100;
/// Columns of boxes can be filled in so many ways at most.
constexpr double kMostWays = 6000;

/// A piece of an axis: sites from `from` on, so many of them, going round where the axis is a ring.
struct Piece {
  int from, length;
};

/// Cuts an axis into pieces of a length, with the first cut at random. On a ring that a single piece would
/// close, the piece leaves `reach` sites out, so that no factor sees both of its ends.
std::vector<Piece> pieces(int extent, int length, bool ring, int reach, RandomStream& random) {
  std::vector<Piece> result;
  if (ring && length >= extent) {
    const int rest = std::max(1, extent - reach);
    return {{static_cast<int>(random.below(static_cast<std::uint64_t>(extent))), rest}};
  }
  const int shift = static_cast<int>(random.below(static_cast<std::uint64_t>(length)));
  for (int from = length >= extent ? 0 : -shift; from < extent; from += length) {
    const int begin = std::max(0, from), end = std::min(extent, from + length);
    if (begin < end) result.push_back({begin, end - begin});
  }
  return result;
}

/// Returns how many ways there are at the most to fill three sites in a row along some axis.
std::size_t columns_of_three(const Style& style) {
  std::size_t most = 0;
  for (const PairRules& pairs : style.pairs) {
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      std::size_t count = 0;
      for (std::size_t tile = 0; tile < style.tileset.size(); ++tile) {
        const auto middle = static_cast<Tile>(tile);
        count += pairs.beside(middle, axis, 1).size() * pairs.beside(middle, axis, -1).size();
      }
      most = std::max(most, count);
    }
  }
  return most;
}

/// Returns in how many ways columns along an axis can be filled, one after the other by their height from 1
/// on.
std::vector<double> ways_by_height(const PairRules& pairs, std::size_t tiles, std::size_t axis, int most) {
  std::vector<double> ending(tiles, 1.0), ways;
  for (int height = 1; height <= most; ++height) {
    double sum = 0;
    for (const double each : ending) sum += each;
    ways.push_back(sum);
    std::vector<double> next(tiles, 0.0);
    for (std::size_t tile = 0; tile < tiles; ++tile) {
      pairs.beside(static_cast<Tile>(tile), axis, -1).for_each([&](Tile before) {
        next[tile] += ending[before];
      });
    }
    ending = std::move(next);
  }
  return ways;
}

}  // namespace

int SweepPlan::affordable_height(int most) const {
  int height = most;
  const Style& style = problem_.style();
  for (const std::size_t axis : axes_) {
    const auto kinds = static_cast<double>(kinds_beside(axis));
    for (const PairRules& pairs : style.pairs) {
      const std::vector<double> ways = ways_by_height(pairs, style.tileset.size(), axis, most);
      const auto known_ways = [&] {
        return std::min(ways[static_cast<std::size_t>(height - 1)], std::pow(kinds, height));
      };
      while (height > 2 && known_ways() > kMostWays) --height;
    }
  }
  return height;
}

/// Returns how many tiles of a column along an axis the next column tells apart: those of which factors know,
/// or else those beside which different tiles may stand.
std::size_t SweepPlan::kinds_beside(std::size_t axis) const {
  const Style& style = problem_.style();
  const auto is_large = [](const SoftShape& shape) { return shape.patches.shape().volume() > 1; };
  if (std::ranges::any_of(style.shapes, is_large)) return style.tileset.size();
  Sides sides = 0;
  for (const std::size_t other : axes_) {
    if (other != axis) sides |= side(other, 1);
  }
  return TileClasses(style).count(sides);
}

SweepPlan::SweepPlan(const Problem& problem)
    : problem_(problem), thickest_(columns_of_three(problem.style()) <= kMostColumns ? 3 : 2) {
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (problem.size().extent[axis] > 1) axes_.push_back(axis);
    reach_[axis] = 1;
    for (const SoftShape& shape : problem.style().shapes) {
      reach_[axis] = std::max(reach_[axis], shape.patches.shape().extent[axis] - 1);
    }
  }
  if (axes_.empty()) axes_.push_back(0);
}

SweepPlan::Windows SweepPlan::bands(std::uint64_t sweep, RandomStream& random) const {
  Point lengths{1, 1, 1};
  const std::size_t along = sweep % axes_.size();
  lengths[axes_[along]] = kLongestBand;
  if (sweep / axes_.size() % kThickEvery == kThickEvery - 1 && axes_.size() > 1) {
    lengths[axes_[(along + 1) % axes_.size()]] =
        2 + static_cast<int>(random.below(static_cast<std::uint64_t>(thickest_ - 1)));
  }
  return cut(lengths, axes_[along], random);
}

SweepPlan::Windows SweepPlan::boxes(int length, int height, std::uint64_t sweep, RandomStream& random) const {
  Point lengths{1, 1, 1};
  const std::size_t along = sweep % axes_.size();
  for (const std::size_t axis : axes_) lengths[axis] = height;
  lengths[axes_[along]] = length;
  return cut(lengths, axes_[along], random);
}

/// Returns boxes of the lengths. The sites of each run across first, and at last along an axis.
SweepPlan::Windows SweepPlan::cut(const Point& lengths, std::size_t along, RandomStream& random) const {
  const Size& size = problem_.size();
  std::array<std::vector<Piece>, kAxes> by_axis;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    by_axis[axis] = pieces(size.extent[axis], std::min(lengths[axis], size.extent[axis]),
                           problem_.topology().periodic[axis], reach_[axis], random);
  }
  std::array<std::size_t, kAxes> order{along, (along + 1) % kAxes, (along + 2) % kAxes};
  Windows windows;
  for (const Piece& x : by_axis[0]) {
    for (const Piece& y : by_axis[1]) {
      for (const Piece& z : by_axis[2]) {
        const Piece piece[] = {x, y, z};
        auto& sites = windows.emplace_back();
        Point at{};
        const auto from = [&](std::size_t axis, int offset) {
          at[axis] = (piece[axis].from + offset) % size.extent[axis];
        };
        for (int i = 0; i < piece[order[0]].length; ++i) {
          from(order[0], i);
          for (int j = 0; j < piece[order[1]].length; ++j) {
            from(order[1], j);
            for (int k = 0; k < piece[order[2]].length; ++k) {
              from(order[2], k);
              sites.push_back(static_cast<std::uint32_t>(size.site(at)));
            }
          }
        }
      }
    }
  }
  return windows;
}

}  // namespace solitaire::tiles
