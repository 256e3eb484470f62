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
  /// Z3's default solver for all theories, which is incremental from its second check on, and not the one for
  /// bit-vectors.
  bool default_solver = false;
  /// Of every int, in bits; 0: the least that holds all its values. See Encoder.
  unsigned fixed_width = 0;
};

/// The reference back end: Z3's incremental bit-vector solver, on the encoding of encode.h. With a fixed
/// width add_clause and check throw ChoiceTooWide.
std::unique_ptr<Solver> make_z3_solver(const Graph& graph, const AddressTable& addresses,
                                       const Z3Options& options);

/// The conditions as an SMT-LIB 2 script, with a (check-sat) at its end. Choices are named after their
/// addresses.
std::string to_smt2(const Graph& graph, const AddressTable& addresses, std::span<const NodeId> conditions);

}  // namespace solitaire
