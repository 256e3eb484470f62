#pragma once
#include <set>
#include <span>

#include "tracegraph/graph.h"

namespace solitaire {

/// The numbers of all choice variables that the nodes depend on.
std::set<std::size_t> variables_below(const Graph& graph, std::span<const NodeId> nodes);

}  // namespace solitaire
