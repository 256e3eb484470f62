#pragma once
#include <cstdint>
#include <memory>

#include "smt/solver.h"
#include "smt/tuning.h"
#include "tracegraph/graph.h"

namespace solitaire {

struct NearbyOptions {
  std::uint64_t seed = 0;
  /// If true, models are as far from each other as can be; else they come sooner and are still far apart.
  bool far_apart = false;
  /// CaDiCaL gives up after so many conflicts near suggested values, and on each further way that it tries
  /// before it goes on without such a limit.
  std::uint64_t conflicts_near_suggestions = tuning::kConflictsNearSuggestions;
  std::uint64_t conflicts_of_one_way = tuning::kConflictsOfOneWay;
};

/// Makes the back end for many models that differ much. Each check has two steps:
///
/// 1. NearbySearch looks for a model near the suggested values. It is the faster one where there are many
///    models, and gives up early where there are few. It proves nothing.
/// 2. If it gave up, CaDiCaL decides. It starts from the values to which the search had come, and follows
///    them for some hundred conflicts. After these it goes its own way, so that hard formulas stay solvable.
///
/// If nothing was suggested since CaDiCaL was asked the last time, a check is the second step alone. What is
/// asked before anything was ever suggested, as whether executions come to errors, is mostly refuted, and
/// CaDiCaL is set up for that until then. Both steps work on the same clauses, which CaDiCaL gets when it is
/// first needed. The same calls with the same seed give the same models. add_clause and check throw
/// UnsupportedOperation.
std::unique_ptr<Solver> make_nearby_then_cadical(const Graph& graph, const NearbyOptions& options);

}  // namespace solitaire
