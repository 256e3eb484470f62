#pragma once
#include <set>
#include <span>
#include <vector>

#include "tracegraph/graph.h"

namespace solitaire {

/// The numbers of all choice variables that the nodes depend on.
std::set<std::size_t> variables_below(const Graph& graph, std::span<const NodeId> nodes);

/// The conjuncts of all conditions, each once, without those that always hold.
std::vector<NodeId> conjuncts(const Graph& graph, std::vector<NodeId> conditions);

}  // namespace solitaire
