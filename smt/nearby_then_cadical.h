#pragma once
#include <cstdint>
#include <memory>

#include "smt/solver.h"
#include "tracegraph/graph.h"

namespace solitaire {

struct NearbyOptions {
  std::uint64_t seed = 0;
  /// If true, models are as far from each other as can be; else they come sooner and are still far apart.
  bool far_apart = false;
};

/// Makes the back end for many models that differ much. Each check goes in two steps:
///
/// 1. NearbySearch looks for a model near the suggested values. It is the faster one where models are many,
/// and
///    it gives up early where they are few. It proves nothing.
/// 2. CaDiCaL decides what the first step left open. It starts from the values that the search had come to,
/// and
///    follows them for some hundred conflicts; after these it goes its own way, so that hard formulas stay
///    solvable.
///
/// Without new suggestions since the last time that CaDiCaL was asked, a check is the second step alone. Both
/// work on the same clauses, which CaDiCaL gets when it is first needed. The same calls with the same seed
/// give the same models. add_clause and check throw UnsupportedOperation.
std::unique_ptr<Solver> make_nearby_then_cadical(const Graph& graph, const NearbyOptions& options);

}  // namespace solitaire
