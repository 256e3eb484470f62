#pragma once
#include <span>
#include <string>

#include "tracegraph/address.h"
#include "tracegraph/graph.h"

namespace solitaire {

/// Returns the conditions as an SMT-LIB 2 script that ends in (check-sat). Each choice is a constant named
/// after its address and its number in the graph. Throws UnsupportedOperation.
///
/// The script shares no code with the encodings of the solvers, so that deciding it with another solver
/// checks them: every int is a two's complement bit-vector of the fewest bits that hold its interval, and an
/// operation is computed at a width that holds all its operands and its result.
std::string to_smt2(const Graph& graph, const AddressTable& addresses, std::span<const NodeId> conditions);

}  // namespace solitaire
