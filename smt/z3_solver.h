#pragma once
#include <memory>
#include <string>

#include "smt/solver.h"

namespace solitaire {

struct Z3Options {
  std::uint64_t seed = 0;
  /// Whether decisions start from random values, which makes successive solutions differ much. Costs some
  /// speed.
  bool random_phase = true;
};

/// The reference back end: Z3's incremental bit-vector solver, on the encoding of encode.h.
std::unique_ptr<Solver> make_z3_solver(const Graph& graph, const AddressTable& addresses,
                                       const Z3Options& options);

/// The conditions as an SMT-LIB 2 script, with a (check-sat) at its end. Choices are named after their
/// addresses.
std::string to_smt2(const Graph& graph, const AddressTable& addresses, std::span<const NodeId> conditions);

}  // namespace solitaire
