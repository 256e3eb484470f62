#pragma once
#include <span>

#include "tracegraph/graph.h"

namespace solitaire {

/// Returns true if the floats visibly sum to 1: as the parts of a stick that is broken piece by piece
///
///     v1, (1 - v1) v2, (1 - v1) (1 - v2) v3, ..., and what is left,
///
/// which is how Dirichlet distributions are drawn, or as a selection among such lists by one condition. That
/// it returns false means nothing.
bool sums_to_one(const Graph& graph, std::span<const NodeId> parts);

}  // namespace solitaire
