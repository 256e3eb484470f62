#pragma once
#include <cstddef>
#include <cstdint>

namespace solitaire {

/// A SAT solver that knows parities as constraints, in a module of its own that is loaded when it is asked
/// for. Nothing of the C++ library crosses between the two, no exceptions either, so each may have its own.
///
/// Literals and variables are numbered as in DIMACS.
class XorSolver {
 public:
  enum class Verdict { kSatisfiable, kUnsatisfiable, kUndecided, kOutOfMemory };

  virtual ~XorSolver() = default;
  /// False if there is not enough memory, as below.
  virtual bool add_clause(const int* literals, std::size_t size) noexcept = 0;
  /// Of these variables an odd number is true, or an even one.
  virtual bool add_xor(const int* variables, std::size_t size, bool odd) noexcept = 0;
  /// Undecided after so many conflicts.
  virtual Verdict solve(std::uint64_t conflicts) noexcept = 0;
  /// In the model found last.
  virtual bool holds(int variable) const noexcept = 0;
};

/// What the module exports as make_xor_solver: of variables 1 to `variables`; null if there is not enough
/// memory.
using MakeXorSolver = XorSolver* (*)(int variables) noexcept;

}  // namespace solitaire
