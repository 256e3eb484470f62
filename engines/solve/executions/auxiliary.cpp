#include "engines/solve/executions/auxiliary.h"

#include <algorithm>
#include <array>
#include <vector>

#include "tracegraph/cone.h"

namespace solitaire {
namespace {

/// The conjuncts of all that is required on all paths.
std::vector<NodeId> required(const Graph& graph, const Trace& trace) {
  std::vector<NodeId> conditions;
  for (const Term& term : trace.hard_terms) {
    if (term.guard == kTrue) conditions.push_back(term.node);
  }
  return conjuncts(graph, std::move(conditions));
}

/// Takes the choice out of `open` that an equality gives the value of, if all others below it are known.
/// Returns true if there was such a choice.
bool take_determined(const Graph& graph, NodeId equality, std::set<std::size_t>& open) {
  const Graph::Node& node = graph.node(equality);
  if (node.op != Op::kEqInt && node.op != Op::kEqBool) return false;
  const std::array sides = {node.args()[0], node.args()[1]};
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const auto is_open = [&](std::size_t variable) { return open.contains(variable); };
    const std::size_t number = graph.node(sides[i]).payload;
    if (graph.node(sides[i]).op != Op::kChoice || !is_open(number)) continue;
    if (std::ranges::any_of(variables_below(graph, {&sides[1 - i], 1}), is_open)) continue;
    return open.erase(number) > 0;
  }
  return false;
}

}  // namespace

std::unordered_set<AddressId> auxiliary_choices(const Trace& trace) {
  std::unordered_set<AddressId> addresses;
  for (const TraceChoice& choice : trace.choices) {
    if (choice.auxiliary) addresses.insert(choice.address);
  }
  return addresses;
}

std::set<std::size_t> auxiliary_variables(const Graph& graph, const Trace& trace) {
  std::set<std::size_t> variables;
  for (const TraceChoice& choice : trace.choices) {
    if (choice.auxiliary && !graph.node(choice.variable).is_constant())
      variables.insert(graph.node(choice.variable).payload);
  }
  return variables;
}

bool follow_from_others(const Graph& graph, const Trace& trace) {
  std::set<std::size_t> open = auxiliary_variables(graph, trace);
  const std::vector<NodeId> conditions = open.empty() ? std::vector<NodeId>{} : required(graph, trace);
  for (bool any = true; any && !open.empty();) {  // one can be known by another
    any = false;
    for (const NodeId condition : conditions) any = take_determined(graph, condition, open) || any;
  }
  return open.empty();
}

Valuation without(const std::unordered_set<AddressId>& auxiliary, const Valuation& values) {
  Valuation others;
  for (const auto& [address, value] : values) {
    if (auxiliary.count(address) == 0) others.emplace(address, value);
  }
  return others;
}

}  // namespace solitaire
