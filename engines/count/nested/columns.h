#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "tracegraph/graph.h"

namespace solitaire {

/// The values of a node in many cases, one after the other; bools are 0 and 1.
using Column = std::vector<std::int32_t>;

/// Returns true if the values of the node fit into a column.
bool fits_column(const Graph& graph, NodeId node);

/// Computes the node from columns of its operands in all of `size` cases, which is many times as fast as to
/// do so case by case. The column of a table is not looked at. What has no value, as after a division by
/// zero, counts as 0: other conditions rule such cases out.
void compute_column(const Graph& graph, NodeId node, const std::array<const std::int32_t*, 3>& operands,
                    std::size_t size, std::int32_t* result);

}  // namespace solitaire
