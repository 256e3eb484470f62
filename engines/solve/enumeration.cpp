#include "engines/solve/enumeration.h"

#include "engines/solve/conclusions/symmetry.h"
#include "engines/solve/executions/meeting.h"

namespace solitaire {

Enumeration::Enumeration(ExecutionSolver& solver, std::vector<NodeId> conditions, bool one_of_alike)
    : graph_(solver.graph()) {
  Graph& graph = solver.graph();
  const MeetingConditions meeting = meeting_conditions(graph, solver.trace());
  const std::vector<NodeId> fixed = fixed_unmet_choices(graph, meeting);
  conditions.insert(conditions.end(), fixed.begin(), fixed.end());
  if (one_of_alike) {
    symmetry_breaking_ = symmetry_breaking(graph, solver.addresses(), solver.pass(), conditions);
    conditions.insert(conditions.end(), symmetry_breaking_.begin(), symmetry_breaking_.end());
  }
  conditions.insert(conditions.end(), solver.implied().begin(), solver.implied().end());
  std::erase(conditions, kTrue);
  std::vector<std::size_t> choices;
  for (const auto& [variable, condition] : meeting) choices.push_back(variable);
  enumerator_ = std::make_unique<Enumerator>(graph, conditions, choices);
}

Enumeration::Outcome Enumeration::next(const StopSignal& stop, std::uint64_t most_dead_ends) {
  const Outcome outcome = enumerator_->next(stop, most_dead_ends);
  begun_ = begun_ || outcome == Outcome::kFound;
  return outcome;
}

void Enumeration::begin_near(Assignment& solution) {
  begun_ = true;
  enumerator_->begin_near(
      [&](std::size_t variable) { return solution.value(graph_.variable_node(variable))->i; });
}

Assignment& Enumeration::assignment() {
  if (assignment_) {
    assignment_->take_changes();
  } else {
    assignment_.emplace(graph_, [values = enumerator_.get()](std::size_t variable) {
      return Scalar::of(values->value(variable));
    });
  }
  return *assignment_;
}

}  // namespace solitaire
