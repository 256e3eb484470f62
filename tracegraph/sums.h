#pragma once
#include <cstdint>
#include <vector>

#include "tracegraph/graph.h"

namespace solitaire {

/// Returns the sum of int nodes, as a balanced tree, in which most sums are narrow; 0 if there are none. What
/// is more than `cap` becomes `cap`, if no term is negative. Throws IntegerTooLarge.
NodeId sum_of(Graph& graph, std::vector<NodeId> terms, std::int64_t cap = INT64_MAX);

/// Returns the number of the bool nodes that are true, or `cap` if more are, so that no number in it is
/// larger than need be.
NodeId count_of(Graph& graph, const std::vector<NodeId>& conditions, std::int64_t cap = INT64_MAX);

}  // namespace solitaire
