#pragma once
#include <vector>

#include "base/random.h"
#include "engines/tiles/model/problem.h"

namespace solitaire::tiles {

/// Cuts a map into windows, differently in each sweep.
class SweepPlan {
 public:
  explicit SweepPlan(const Problem& problem);

  using Windows = std::vector<std::vector<std::uint32_t>>;
  /// Returns bands: rows and columns in turns, most of them one site high, every fourth two, or three where
  /// that does not take too long.
  Windows bands(std::uint64_t sweep, RandomStream& random) const;
  /// Returns the largest height, up to `most`, of boxes whose columns can be filled in so few ways that
  /// redrawing them does not take long; at least 2.
  int affordable_height(int most) const;
  /// Returns boxes of up to so many sites along each axis that is longer than 1.
  Windows boxes(int length, int height, std::uint64_t sweep, RandomStream& random) const;

 private:
  Windows cut(const Point& lengths, std::size_t along, RandomStream& random) const;
  std::size_t kinds_beside(std::size_t axis) const;

  const Problem& problem_;
  int thickest_;                   // of bands, in sites
  std::vector<std::size_t> axes_;  // those longer than 1
  Point reach_{};                  // how far factors reach along an axis
};

}  // namespace solitaire::tiles
