#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "base/random.h"
#include "base/stop_signal.h"
#include "engines/count/nested/nested_bounds.h"
#include "engines/count/nested/tuning.h"

namespace solitaire {

/// How many cases a cluster may have, and the places that are kept may have in all.
struct NestedLimits {
  std::size_t most_in_cluster = tuning::kMostInCluster;
  std::size_t most_cases_kept = tuning::kMostCasesKept;
};

/// Draws what the clusters of a network can be together, each of all solutions with exactly the same
/// probability (up to the rounding of floats), each draw independent of those before.
///
/// One cluster after the other is chosen, in a fixed order. What is left of those that follow bounds how many
/// solutions there are below: the product of their sizes, once all that does not fit what was chosen is taken
/// away. Each case is chosen with a probability in proportion to its bound. The bounds of all cases are
/// together no larger than the bound that this place was chosen for; for what is missing, the attempt is
/// given up and another one starts from the beginning. So each solution comes from an attempt with the
/// probability 1 / first bound. This is sampling with nested bounds (Huber, "Exact sampling from perfect
/// matchings of dense regular bipartite graphs", 2006; Kuck and others, "Approximating the Permanent by
/// Sampling from Adaptive Partitions", 2019).
///
/// Before the first draw, places that are come to are kept with the sum of the bounds of their cases, which
/// replaces the bound that they were chosen for. So fewer attempts fail.
class NestedSampler {
 public:
  /// Returns nothing where attempts hardly ever succeed. Throws Interrupted.
  static std::optional<NestedSampler> prepared(ClusterNetwork network, RandomStream random,
                                               const StopSignal& stop, std::size_t most_cases_kept);

  /// Depends on the stream alone. Throws Interrupted.
  Cases draw(RandomStream& random, const StopSignal& stop);
  /// Returns whether an attempt succeeds. It does with the probability of the number of solutions divided by
  /// bound(). Throws Interrupted.
  bool succeeds(RandomStream& random, const StopSignal& stop);
  double bound() const { return places_.front().total; }
  /// About how many solutions there are: a guess.
  double guessed_solutions() const { return bound() * success_; }
  const Clusters& clusters() const { return bounds_.clusters(); }

 private:
  /// Which case was taken at a place that is kept.
  struct Step {
    std::uint32_t place;
    std::size_t at;
  };

  NestedSampler(NestedBounds bounds, std::vector<std::size_t> order, Place first, std::size_t most_cases_kept)
      : bounds_(std::move(bounds)),
        order_(std::move(order)),
        most_cases_kept_(most_cases_kept),
        places_{std::move(first)} {}

  bool prepare(RandomStream& random, const StopSignal& stop);
  std::optional<Cases> attempt(RandomStream& random, const StopSignal& stop, bool keep);
  void keep(const Place& place, const std::vector<Step>& path);
  void tighten(const std::vector<Step>& path, double total);

  NestedBounds bounds_;
  std::vector<std::size_t> order_;
  std::size_t most_cases_kept_;
  std::vector<Place> places_;  // the first is where nothing is chosen
  std::size_t cases_kept_ = 0;
  double success_ = 0;  // the part of attempts that succeeded when all was prepared
};

}  // namespace solitaire
