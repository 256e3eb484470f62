#pragma once
#include <cstddef>
#include <deque>
#include <functional>
#include <optional>
#include <vector>

#include "engines/distance.h"
#include "engines/solution.h"

namespace solitaire {

/// Keeps the solutions of a block away from those of blocks before it, of which its search does not know.
/// One that is near another is put aside, and a further one is looked for. Where that is in vain, the one
/// that is farthest will do, and it is tried more and more rarely; in between, solutions that were put aside
/// come next. So what was found is hardly ever lost.
///
/// Only the first solutions of a series are kept apart: of many, some are near each other anyway.
class BlockDistance {
 public:
  using Find = std::function<std::optional<Solution>()>;

  /// What is nearer to another solution than this is near.
  explicit BlockDistance(double near) : near_(near) {}

  /// Takes note of a solution of the series.
  void add(const Solution& solution);
  /// Begins a block, which is to be kept away from all solutions so far.
  void start_block();
  /// Returns a solution of those that `find` gives, or nothing once it gives none.
  std::optional<Solution> next(const Find& find);
  /// Returns the farthest of the solutions that were put aside, if any. They come last where a block has
  /// nothing else.
  std::optional<Solution> take_aside();

 private:
  struct Near {
    Solution solution;
    double distance;
  };
  double distance(const Solution& solution) const;

  double near_;
  std::vector<HashedFeatures> all_;  // the choices of the first solutions
  std::size_t others_ = 0;           // so many of them are of blocks before
  std::deque<Near> aside_;
  unsigned in_vain_ = 0;  // so many times in a row nothing was found that is far enough
  unsigned to_skip_ = 0;  // so many solutions are not to be looked at
};

}  // namespace solitaire
