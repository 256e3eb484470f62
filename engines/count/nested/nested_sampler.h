#pragma once
#include "base/random.h"
#include "base/stop_signal.h"
#include "engines/count/nested/cluster_network.h"
#include "engines/count/nested/tuning.h"

namespace solitaire {

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
                                               const StopSignal& stop);

  /// Depends on the stream alone. Throws Interrupted.
  Cases draw(RandomStream& random, const StopSignal& stop);
  /// Returns whether an attempt succeeds. It does with the probability of the number of solutions divided by
  /// bound(). Throws Interrupted.
  bool succeeds(RandomStream& random, const StopSignal& stop);
  double bound() const { return places_.front().total; }
  /// About how many solutions there are: a guess.
  double guessed_solutions() const { return bound() * success_; }
  const Clusters& clusters() const { return network_.clusters(); }

 private:
  /// A case of the cluster that is chosen next, with the bound on what is below.
  struct Case {
    std::uint32_t number;
    std::uint32_t place;  // in places_, or 0 if it was not kept
    double bound;
  };
  /// Where so many clusters are chosen.
  struct Place {
    std::vector<Case> cases;
    double total = 0;
  };
  /// What is chosen, and what is left of the clusters that are not.
  struct State {
    std::vector<ShrinkingSet> left;
    std::vector<std::size_t> sizes;
    Cases chosen;
    std::vector<bool> is_chosen;
  };

  explicit NestedSampler(ClusterNetwork network);

  bool find_order(RandomStream& random, const StopSignal& stop);
  bool prepare(RandomStream& random, const StopSignal& stop);
  double estimated_total(const State& state, std::size_t cluster);
  Place place(const State& state, std::size_t cluster, const StopSignal& stop);
  double bound_of(const State& state, std::size_t cluster, std::uint32_t number);
  void choose(State& state, std::size_t cluster, std::uint32_t number);
  std::optional<Cases> attempt(RandomStream& random, const StopSignal& stop, bool keep);
  void tighten(const std::vector<std::pair<std::uint32_t, std::size_t>>& path, double total);
  static std::size_t picked(const Place& place, RandomStream& random);
  std::uint64_t work() const { return work_ + network_.work(); }

  ClusterNetwork network_;
  std::vector<std::size_t> order_;
  State start_;
  std::vector<Place> places_;  // the first is where nothing is chosen
  std::size_t cases_kept_ = 0;
  std::uint64_t work_ = 0;                                  // in words of sets
  std::uint64_t most_work_ = tuning::kMostWorkInPreparing;  // of this and the network
  double success_ = 0;  // the part of attempts that succeeded when all was prepared
};

}  // namespace solitaire
