#pragma once
#include <memory>

#include "smt/solver.h"

namespace solitaire {

struct CadicalOptions {
  std::uint64_t seed = 0;
  /// Many models far from each other, and not a proof, are what is looked for. Else it takes no suggestions.
  bool diverse = false;
  /// Percent of the variables that stand for no choice, and are tried with a random sign first where values
  /// are suggested: which of several alternatives holds is then drawn, too.
  unsigned random_signs = 10;
};

/// The fast back end: CaDiCaL on the clauses that cnf.h writes of the circuits of bit_blast.h. The same calls
/// with the same seed give the same models.
std::unique_ptr<Solver> make_cadical_solver(const Graph& graph, const CadicalOptions& options);

}  // namespace solitaire
