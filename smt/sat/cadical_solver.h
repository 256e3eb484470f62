#pragma once
#include <memory>

#include "smt/solver.h"

namespace solitaire {

struct CadicalOptions {
  std::uint64_t seed = 0;
  /// Many models far from each other, and not a proof, are what is looked for. Else it takes no suggestions.
  bool diverse = false;
  /// With these, models as far from each other as can be rather than soon.
  bool far_apart = false;
};

/// The fast back end: nearby_search.h and CaDiCaL on the clauses that cnf.h writes of the circuits of
/// bit_blast.h. The same calls with the same seed give the same models.
std::unique_ptr<Solver> make_cadical_solver(const Graph& graph, const CadicalOptions& options);

}  // namespace solitaire
