#pragma once
#include <algorithm>
#include <cstdint>
#include <vector>

#include "tracegraph/assignment.h"
#include "tracegraph/graph.h"

namespace solitaire {

/// Returns true if some values of the choices fulfil all of the conditions.
inline bool can_hold(const Graph& graph, const std::vector<NodeId>& conditions) {
  std::vector<std::int64_t> values;
  for (const ChoiceVariable& variable : graph.variables()) values.push_back(variable.domain.lo);
  while (true) {
    Assignment assignment(graph, [&](std::size_t number) { return Scalar::of(values[number]); });
    if (std::ranges::all_of(conditions, [&](NodeId condition) { return assignment.holds(condition); }))
      return true;
    std::size_t at = 0;
    while (at < values.size() && values[at] == graph.variables()[at].domain.hi)
      values[at] = graph.variables()[at].domain.lo, ++at;
    if (at == values.size()) return false;
    ++values[at];
  }
}

}  // namespace solitaire
