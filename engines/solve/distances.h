#pragma once
#include <vector>

#include "engines/solve/executions/execution_solver.h"
#include "engines/solve/executions/min_distance.h"

namespace solitaire {

/// Keeps solutions at a distance from earlier ones. The solver is told of an earlier solution only once a
/// model is too near to it: telling it of all from the start would slow it down for what most models fulfil
/// by chance.
class Distances {
 public:
  Distances(ExecutionSolver& solver, const DistanceBound& bound) : solver_(solver), bound_(bound) {}

  /// Adds a solution from which the next ones keep away.
  void keep_away_from(Valuation solution);
  /// Returns true if the model is too near to some solution; then the solver was told of these, and has to be
  /// asked again.
  bool too_near(const Valuation& model);
  /// Returns a condition for each solution, whether the solver was told of it or not.
  std::vector<NodeId> conditions();

 private:
  struct KeptAway {
    Valuation values;
    std::size_t told_in_pass = 0;  // the last pass in which the solver was told of it
  };
  NodeId condition(const KeptAway& kept);
  Valuation shown(const KeptAway& kept) const;

  ExecutionSolver& solver_;
  DistanceBound bound_;
  std::vector<KeptAway> kept_;
};

}  // namespace solitaire
