#include "engines/thesis/all_different.h"

#include <map>

namespace solitaire {
namespace {

struct ConditionalChoice {
  const TraceChoice* choice;
  NodeId exists = kFalse;
};

/// Exclusive branches can share a choice, which then exists on each of them.
std::vector<ConditionalChoice> choices_of(Graph& graph, const Trace& trace) {
  std::map<std::uint32_t, ConditionalChoice> by_variable;
  for (const TraceChoice& choice : trace.choices) {
    ConditionalChoice& known = by_variable.try_emplace(choice.variable.index).first->second;
    known.choice = &choice;
    known.exists = graph.disjunction(known.exists, choice.guard);
  }
  std::vector<ConditionalChoice> choices;
  for (const auto& [variable, choice] : by_variable) choices.push_back(choice);
  return choices;
}

NodeId equals(Graph& graph, const TraceChoice& choice, std::int64_t value) {
  return graph.apply(Op::kEqInt, {choice.variable, graph.constant(value)});
}

std::int64_t reserved_value(const Graph& graph, const TraceChoice& choice) {
  return graph.node(choice.variable).interval.lo;
}

}  // namespace

std::vector<NodeId> reserved_values(Graph& graph, const Trace& trace) {
  std::vector<NodeId> conditions;
  for (const auto& [choice, exists] : choices_of(graph, trace)) {
    const NodeId reserved = equals(graph, *choice, reserved_value(graph, *choice));
    const NodeId condition = graph.disjunction(exists, reserved);
    if (condition != kTrue) conditions.push_back(condition);
  }
  return conditions;
}

std::vector<NodeId> differences(Graph& graph, const Trace& trace, const Valuation& solution) {
  std::vector<NodeId> conditions;
  for (const auto& [choice, exists] : choices_of(graph, trace)) {
    if (choice->auxiliary) continue;
    const auto value = solution.find(choice->address);
    const NodeId equal = equals(
        graph, *choice, value == solution.end() ? reserved_value(graph, *choice) : value->second.as_int());
    const NodeId condition = graph.conjunction(exists, graph.negation(equal));
    if (condition != kFalse) conditions.push_back(condition);
  }
  return conditions;
}

}  // namespace solitaire
