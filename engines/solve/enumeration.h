#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "engines/solve/executions/execution_solver.h"
#include "smt/cdcl/enumerator.h"
#include "smt/tuning.h"
#include "tracegraph/assignment.h"

namespace solitaire {

/// Goes through the solutions of a trace in order, without the solver. All paths have to be explored, and the
/// solutions have to be all as good.
class Enumeration {
 public:
  /// `conditions` hold in the solutions to go through. With `one_of_alike`, some of those that look like
  /// others are left out.
  Enumeration(ExecutionSolver& solver, std::vector<NodeId> conditions, bool one_of_alike);

  using Outcome = Enumerator::Outcome;
  /// Goes to the next solution, and gives up after so many dead ends. Any outcome but kFound is the last,
  /// unless there is begin_near().
  Outcome next(const StopSignal& stop, std::uint64_t most_dead_ends = tuning::kMostDeadEnds);
  /// Returns true if no solution was found, and those next to one that another search finds can come first.
  bool may_begin_near() const { return !begun_; }
  /// Begins at a solution, of which the assignment has the values.
  void begin_near(Assignment& solution);
  /// Returns the values of the choices' variables, until next() is called. For use after kFound.
  Assignment& assignment();
  /// Returns the conditions by which solutions that look like others were left out.
  const std::vector<NodeId>& left_out() const { return symmetry_breaking_; }

 private:
  const Graph& graph_;
  std::vector<NodeId> symmetry_breaking_;
  std::unique_ptr<Enumerator> enumerator_;
  std::optional<Assignment> assignment_;  // of the last solution that was asked for
  bool begun_ = false;                    // it was at a solution, or is going to one
};

}  // namespace solitaire
