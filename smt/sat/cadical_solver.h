#pragma once
#include <cstdint>
#include <memory>

#include "smt/solver.h"
#include "tracegraph/graph.h"

namespace solitaire {

/// Makes the back end that is CaDiCaL alone, on the clauses of graph_clauses.h. It takes no suggestions. The
/// same calls with the same seed give the same models. add_clause and check throw UnsupportedOperation.
std::unique_ptr<Solver> make_cadical_solver(const Graph& graph, std::uint64_t seed = 0);

}  // namespace solitaire
