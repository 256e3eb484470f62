#pragma once
#include <unordered_set>
#include <vector>

#include "engines/solve/conclusions/separations.h"
#include "tracegraph/graph.h"

namespace solitaire {

/// What follows from ints that pairwise differ and are as many as the values that they can have.
struct Permutations {
  std::vector<NodeId> values;  // conditions: exactly one of the ints has that value
  std::vector<NodeId> taken;   // conditions: some of the ints has that value
  std::vector<NodeId> sums;    // conditions: the ints add up to what their values do
  /// Equations that `values` rule out, between ints that are looked up in lists: to compare such ints is
  /// dear.
  std::unordered_set<NodeId> ruled_out;
};

/// Looks for ints that pairwise differ and are as many as the values that they can have. A search that looks
/// at two ints at a time does not see what follows from that, such as where a value must go for which one
/// place is left.
///
/// Ints may stand in the conditions with offsets, as in `x[i] != x[j] + 3`. Groups are chosen greedily. What
/// comes back is true wherever the conditions hold in which the separations were found. The time is by the
/// number of separations and by the number of ints times that of values, of which there are only so many at
/// most.
Permutations find_permutations(Graph& graph, const Separations& separations);

}  // namespace solitaire
