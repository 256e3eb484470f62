#pragma once
#include <set>
#include <span>
#include <vector>

#include "tracegraph/graph.h"

namespace solitaire {

/// Returns the nodes and all that they are made of, each once, in no particular order.
std::vector<NodeId> nodes_below(const Graph& graph, std::span<const NodeId> roots);

/// Returns the numbers of all choice variables that the nodes depend on.
std::set<std::size_t> variables_below(const Graph& graph, std::span<const NodeId> nodes);

/// Returns the conjuncts of all conditions, each once, without those that always hold.
std::vector<NodeId> conjuncts(const Graph& graph, std::vector<NodeId> conditions);

}  // namespace solitaire
