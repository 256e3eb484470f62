#include "engines/solve/auxiliary.h"

namespace solitaire {

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

Valuation without(const std::unordered_set<AddressId>& auxiliary, const Valuation& values) {
  Valuation others;
  for (const auto& [address, value] : values) {
    if (auxiliary.count(address) == 0) others.emplace(address, value);
  }
  return others;
}

}  // namespace solitaire
