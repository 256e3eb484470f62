#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/random.h"
#include "base/stop_signal.h"
#include "engines/count/nested/cluster_network.h"
#include "engines/count/nested/tuning.h"

namespace solitaire {

/// What is chosen of the clusters of a network, and what is left of those that are not.
struct PartialChoice {
  Cases chosen;
  std::vector<bool> is_chosen;
  std::vector<ShrinkingSet> left;
  std::vector<std::size_t> sizes;  // of what is left
};

/// A place where so many clusters are chosen: what the next one can be.
struct Place {
  struct Case {
    std::uint32_t number;
    std::uint32_t place;  // where what follows is kept, if anybody keeps it, or 0
    double bound;         // on the number of solutions below
  };
  std::vector<Case> cases;
  double total = 0;  // of the bounds

  /// Returns the position of a case that is drawn with a probability in proportion to its bound.
  std::size_t draw(RandomStream& random) const;
};

/// Bounds the number of solutions of a network by the product of what is left of its clusters, once all that
/// does not fit what was chosen is taken away. The bounds of a cluster's cases are together no larger than
/// the bound before.
class NestedBounds {
 public:
  /// Thrown where clusters are so large that bounds are too much work.
  struct TooMuchWork {};

  explicit NestedBounds(ClusterNetwork network);

  const Clusters& clusters() const { return network_.clusters(); }
  /// Returns the choice of no cluster yet, with all that they can be.
  PartialChoice start();
  /// Returns what a cluster can be that is not chosen. Throws Interrupted and TooMuchWork.
  Place place(const PartialChoice& choice, std::size_t cluster, const StopSignal& stop);
  /// Returns about what the total of that place is, from some of its cases. Throws TooMuchWork.
  double estimated_total(const PartialChoice& choice, std::size_t cluster);
  void choose(PartialChoice& choice, std::size_t cluster, std::uint32_t number);

  /// Returns how much was done so far, in words of sets that were looked at.
  std::uint64_t work() const { return work_ + network_.work(); }
  void count_work(std::uint64_t words) { work_ += words; }
  /// From now on, nothing is too much work.
  void lift_limit() { most_work_ = UINT64_MAX; }

 private:
  double bound_of(const PartialChoice& choice, std::size_t cluster, std::uint32_t number);
  void restrict_last(PartialChoice& choice, std::size_t wide);

  ClusterNetwork network_;
  PartialChoice start_;
  std::uint64_t work_ = 0;
  std::uint64_t most_work_ = tuning::kMostWorkInPreparing;
};

}  // namespace solitaire
