#pragma once
#include <cstdint>
#include <memory>
#include <span>

#include "base/stop_signal.h"

namespace solitaire {

/// A SAT solver that takes equations modulo 2 as constraints of their own: CryptoMiniSat (Soos, Nohl and
/// Castelluccia, "Extending SAT Solvers to Cryptographic Problems", 2009).
///
/// Variables are numbered from 1, and a negative literal is the negation of its variable. All functions throw
/// std::bad_alloc where there is not enough memory.
class XorSolver {
 public:
  explicit XorSolver(int variables);
  ~XorSolver();

  /// Requires that at least one of the literals holds.
  void clause(std::span<const int> clause);
  /// Requires that the number of these variables that are true is odd, or even.
  void add_xor(std::span<const int> variables, bool odd);
  /// Returns true if the constraints have a model. Throws Interrupted.
  bool satisfiable(const StopSignal& stop);
  /// Returns the value of a variable in the model that satisfiable() found last.
  bool holds(int variable) const;

 private:
  class CryptoMiniSat;
  std::unique_ptr<CryptoMiniSat> solver_;
};

}  // namespace solitaire
