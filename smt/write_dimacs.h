#pragma once
#include <span>
#include <string>

#include "tracegraph/graph.h"

namespace solitaire {

/// The conditions as clauses in the DIMACS format of SAT solvers. Comments say which variables are the bits
/// of which choice.
std::string to_dimacs(const Graph& graph, const AddressTable& addresses, std::span<const NodeId> conditions);

}  // namespace solitaire
