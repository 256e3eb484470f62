#pragma once
#include <cstdint>
#include <memory>

#include "base/stop_signal.h"
#include "engines/tiles/model/problem.h"
#include "engines/tiles/start/outcome.h"

namespace solitaire::tiles {

/// A place of the endless plane: x, y.
using FarPoint = std::array<std::int64_t, 2>;
/// Regions may begin so far from the origin, along each axis.
inline constexpr std::int64_t kFarthest = std::int64_t{1} << 40;

/// A flat map without end, of which any region can be made on its own: what is at a place depends on the
/// style and the seed alone, so that regions which overlap have the same tiles there, and those beside each
/// other meet.
///
/// At first the plane is tiled by one small periodic map. Then layer after layer of windows is redrawn, each
/// from its exact distribution given what is around it. The windows of a layer are so far from each other
/// that no factor sees two of them: each depends on a bounded surrounding and on no order, and so does a
/// region.
class EndlessMap {
 public:
  /// `style` has its weights.
  EndlessMap(std::shared_ptr<const Style> style, std::uint64_t seed);

  /// Makes the periodic map; to be called before all else. kGaveUp if the tiles fit none of the sizes that
  /// are tried, which proves nothing about endless maps.
  Outcome prepare(const StopSignal& stop);
  /// Returns a region of the map. Throws std::length_error where it is too large, and Interrupted.
  Grid region(const FarPoint& from, const Size& size, const StopSignal& stop) const;

 private:
  /// The windows of one layer: boxes of a size that stand in a lattice.
  struct Layer {
    Point size{1, 1, 1};
    FarPoint step{}, offset{};  // of the lattice
  };
  /// A part of the plane, from its first to before its last place.
  struct Part {
    FarPoint from{}, to{};
  };

  Part seen_by(const Layer& layer, const Part& part) const;
  Part windows_that_meet(const Layer& layer, const Part& part) const;
  Grid base_of(const Part& part) const;
  void redraw(std::size_t layer, const Part& part, const Part& whole, const Problem& problem, Grid& map,
              const StopSignal& stop) const;

  std::shared_ptr<const Style> style_;
  std::uint64_t seed_;
  FarPoint reach_{};  // how far factors see along an axis
  std::vector<Layer> layers_;
  Grid base_;
};

}  // namespace solitaire::tiles
