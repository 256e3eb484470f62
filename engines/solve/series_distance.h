#pragma once
#include <cstddef>
#include <deque>
#include <functional>
#include <optional>
#include <vector>

#include "engines/distance.h"
#include "engines/solution.h"

namespace solitaire {

/// Keeps the solutions of a series away from each other. The search of a block does not know those of the
/// blocks before it, and does not look at how far its own are from each other.
///
/// A solution that is near another is put aside, and a further one is looked for. Once several are aside, the
/// farthest of them comes all the same, and from then on only half the distance is asked for. What was put
/// aside comes as soon as it is far enough, so little of what was found is lost.
///
/// What is asked for depends on the solutions alone that were added. So a series that is resumed goes on as
/// it would have.
///
/// Only the first solutions of a series are kept apart: of many, some are near each other anyway.
class SeriesDistance {
 public:
  using Find = std::function<std::optional<Solution>()>;

  /// What is nearer to another solution than `near` is near, as long as no more than `most_aside` are.
  SeriesDistance(double near, std::size_t most_aside) : near_(near), most_aside_(most_aside) {}

  /// Takes note of a solution of the series.
  void add(const Solution& solution);
  /// Begins a block, which may find again what was put aside in the one before.
  void start_block() { aside_.clear(); }
  /// Returns a solution of those that `find` gives, or nothing once it gives none.
  std::optional<Solution> next(const Find& find);
  /// Returns the farthest of the solutions that were put aside, if any. They come last where a block has
  /// nothing else.
  std::optional<Solution> take_aside() { return take_aside(0); }

 private:
  struct Near {
    Solution solution;
    HashedFeatures features;
    double distance;
  };
  std::optional<Solution> take_aside(double least);
  double distance(const HashedFeatures& features) const;

  double near_;
  std::size_t most_aside_;
  std::vector<HashedFeatures> all_;  // the choices of the first solutions
  std::deque<Near> aside_;
};

}  // namespace solitaire
