#pragma once
#include <set>
#include <unordered_set>

#include "tracegraph/graph.h"
#include "tracegraph/trace.h"
#include "tracegraph/valuation.h"

namespace solitaire {

/// The addresses of the auxiliary choices of a trace: solutions that differ in nothing else are one.
std::unordered_set<AddressId> auxiliary_choices(const Trace& trace);
/// The numbers of the graph's variables that stand for them.
std::set<std::size_t> auxiliary_variables(const Graph& graph, const Trace& trace);
/// Returns true if the value of each auxiliary choice follows from the others', since an assert on all paths
/// says which it is: `s == x + y`. Then no two solutions differ in auxiliary choices alone.
bool follow_from_others(const Graph& graph, const Trace& trace);
/// The values of the other choices.
Valuation without(const std::unordered_set<AddressId>& auxiliary, const Valuation& values);

}  // namespace solitaire
