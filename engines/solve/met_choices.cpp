#include "engines/solve/met_choices.h"

namespace solitaire {

MetChoices met_choices(Graph& graph, const Trace& trace) {
  MetChoices met;
  for (const TraceChoice& choice : trace.choices) {
    if (graph.node(choice.variable).is_constant()) continue;
    NodeId& guard = met.try_emplace(graph.node(choice.variable).payload, kFalse).first->second;
    guard = graph.disjunction(guard, choice.guard);
  }
  return met;
}

std::vector<NodeId> fixed_unmet_choices(Graph& graph, const MetChoices& met) {
  std::vector<NodeId> conditions;
  for (const auto& [variable, guard] : met) {
    const NodeId lowest = graph.constant(graph.variables()[variable].domain.lo);
    const NodeId is_lowest = graph.apply(Op::kEqInt, {graph.variable_node(variable), lowest});
    conditions.push_back(graph.disjunction(guard, is_lowest));
  }
  return conditions;
}

}  // namespace solitaire
