#pragma once
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/stop_signal.h"
#include "smt/sat/cnf.h"
#include "smt/xor/xor_solver.h"

namespace solitaire {

/// The values of the literals that models are projected on.
using BitModel = std::vector<bool>;

/// An equation modulo 2: the number of the chosen literals that hold is odd, or even.
struct XorConstraint {
  std::vector<bool> chosen;  // by position among the literals that models are projected on
  bool odd = false;
};

/// Finds the models of a set of clauses, projected on some of their literals: models that agree on these
/// count as one.
///
/// Parities are the business of CryptoMiniSat (Soos, Nohl and Castelluccia, "Extending SAT Solvers to
/// Cryptographic Problems", 2009), which knows them as constraints of their own; without any, CaDiCaL is
/// faster.
class ProjectedModels : public ClauseSink {
 public:
  /// Takes all clauses before the first search.
  void clause(std::span<const int> literals) override;
  /// Sets the literals to project on, which belong to different variables, as clauses number them.
  void project_on(std::vector<int> literals);
  std::size_t bits() const { return projection_.size(); }

  /// Returns different models that fulfil the parities: all, or `most` of them. Which these are, and their
  /// order, depends on the clauses and the parities alone. `found`, if not null, is told the number of models
  /// so far. Throws Interrupted.
  std::vector<BitModel> find(std::span<const XorConstraint> parities, std::size_t most,
                             const StopSignal& stop, std::atomic<std::uint64_t>* found = nullptr) const;

 private:
  void add(const XorConstraint& parity, XorSolver& solver) const;
  template <class Visit>
  void for_each_clause(Visit visit) const;
  template <class ModelSolver, class Satisfiable>
  std::vector<BitModel> list(ModelSolver& solver, Satisfiable satisfiable, std::size_t most,
                             std::atomic<std::uint64_t>* found) const;

  std::vector<int> literals_;      // of all clauses
  std::vector<std::size_t> ends_;  // of each clause among them
  std::vector<int> projection_;
  int variables_ = 0;
};

}  // namespace solitaire
