#include "engines/solve/executions/meeting.h"

namespace solitaire {

MeetingConditions meeting_conditions(Graph& graph, const Trace& trace) {
  MeetingConditions meeting;
  for (const TraceChoice& choice : trace.choices) {
    if (graph.node(choice.variable).is_constant()) continue;
    NodeId& guard = meeting.try_emplace(graph.node(choice.variable).payload, kFalse).first->second;
    guard = graph.disjunction(guard, choice.guard);
  }
  return meeting;
}

std::vector<NodeId> fixed_unmet_choices(Graph& graph, const MeetingConditions& meeting) {
  std::vector<NodeId> conditions;
  for (const auto& [variable, guard] : meeting) {
    const NodeId lowest = graph.constant(graph.variables()[variable].domain.lo);
    const NodeId is_lowest = graph.apply(Op::kEqInt, {graph.variable_node(variable), lowest});
    conditions.push_back(graph.disjunction(guard, is_lowest));
  }
  return conditions;
}

}  // namespace solitaire
