#pragma once
#include <vector>

#include "tracegraph/trace.h"
#include "tracegraph/valuation.h"

namespace solitaire {

// The path-sensitive all-different constraint as section 4.2.3 of the dissertation has it. A choice x with
// the path condition p has a reserved value Q wherever p does not hold, here the lower end of its range; and
// solutions differ in a choice that exists. SearchMethod::difference does without path conditions.

/// Returns "p or x = Q" for each choice of the trace. All of them hold in all solutions.
std::vector<NodeId> reserved_values(Graph& graph, const Trace& trace);

/// Returns "p and x != s" for each choice of the trace, where s is its value in the solution, or Q. At least
/// one of them holds in every other solution.
std::vector<NodeId> differences(Graph& graph, const Trace& trace, const Valuation& solution);

}  // namespace solitaire
