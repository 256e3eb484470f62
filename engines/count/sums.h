#pragma once
#include <cstdint>
#include <vector>

#include "tracegraph/graph.h"

namespace solitaire {

/// The sum of int nodes, as a balanced tree, in which most sums are narrow; 0 of none. What is more than
/// `cap` becomes `cap`, if no term is negative. Throws IntegerTooLarge.
NodeId sum_of(Graph& graph, std::vector<NodeId> terms, std::int64_t cap = INT64_MAX);

/// How many of the bool nodes are true, or `cap` if more are: so no number in it is larger than need be.
NodeId count_of(Graph& graph, const std::vector<NodeId>& conditions, std::int64_t cap = INT64_MAX);

}  // namespace solitaire
