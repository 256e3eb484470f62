#pragma once
#include <memory>
#include <set>
#include <string>

#include "engines/solution.h"
#include "engines/solve/executions/execution_solver.h"

namespace solitaire {

/// Says on which choices it depends what a solution has: those in the cone of the nodes that a placed thing,
/// the cost of an unmet wish, or the condition of a broken assert, is made of.
class Provenance {
 public:
  Provenance(const Program& program, const ParamValues& params, const TracingOptions& options, Pins& pins,
             ExecutionSolver& solver);
  ~Provenance();

  /// Fills in PlacedObject::choices: the choices that decide where the thing stands and what it is.
  void add_object_choices(Solution& solution);
  /// Fills in UnmetWish::choices.
  void add_wish_choices(Solution& solution);
  /// Fills in BrokenAssert::choices: those of what is broken in the condition, such as of one pair of
  /// all_apart(things).
  void add_broken_choices(Solution& solution);

 private:
  class WideTrace;
  Assignment assignment_of(const Solution& solution);
  std::set<std::string> choices_below(const Term& part, Assignment& assignment);

  const Program& program_;
  const ParamValues& params_;
  TracingOptions options_;
  Pins& pins_;
  ExecutionSolver& solver_;
  std::unique_ptr<WideTrace> wide_;  // made when it is first needed
};

}  // namespace solitaire
