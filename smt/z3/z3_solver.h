#pragma once
#include <cstdint>
#include <memory>

#include "smt/solver.h"
#include "tracegraph/address.h"
#include "tracegraph/graph.h"

namespace solitaire {

struct Z3Options {
  std::uint64_t seed = 0;
  /// If true, decisions start from random values. Successive solutions then differ much, at some cost in
  /// speed.
  bool random_phase = true;
  /// If true, Z3's default solver for all theories is used, which is incremental from its second check on,
  /// and not the solver for bit-vectors.
  bool default_solver = false;
  /// The width of every int in bits, or 0 for the least width that holds all its values. See Encoder.
  unsigned fixed_width = 0;
};

/// Makes the reference back end: Z3's incremental bit-vector solver, on the encoding of encode.h. With a
/// fixed width, add_clause and check throw ChoiceTooWide.
std::unique_ptr<Solver> make_z3_solver(const Graph& graph, const AddressTable& addresses,
                                       const Z3Options& options);

}  // namespace solitaire
