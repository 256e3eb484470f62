#pragma once
#include <span>
#include <string>

#include "tracegraph/graph.h"

namespace solitaire {

/// Returns the conditions as clauses in the DIMACS format of SAT solvers. Comments in it say which variables
/// are the bits of which choice.
std::string to_dimacs(const Graph& graph, const AddressTable& addresses, std::span<const NodeId> conditions);

}  // namespace solitaire
