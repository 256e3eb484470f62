#include "engines/solve/executions/requirements.h"

namespace solitaire {

std::vector<NodeId> requirements_of_any_path(Graph& graph, const Trace& trace,
                                             const std::function<bool(const Term&)>& firm) {
  std::vector<NodeId> conditions;
  for (const Term& required : trace.hard_terms) {
    if (!firm || firm(required)) conditions.push_back(graph.implication(required.guard, required.node));
  }
  for (const TraceProgramError& error : trace.program_errors)
    conditions.push_back(graph.negation(error.guard));
  return conditions;
}

std::vector<NodeId> requirements_of(Graph& graph, const Trace& trace,
                                    const std::function<bool(const Term&)>& firm) {
  std::vector<NodeId> conditions = requirements_of_any_path(graph, trace, firm);
  for (const TraceBlocker& blocker : trace.blockers) conditions.push_back(graph.negation(blocker.guard));
  return conditions;
}

}  // namespace solitaire
