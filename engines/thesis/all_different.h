#pragma once
#include <map>
#include <vector>

#include "tracegraph/trace.h"

namespace solitaire {

// The path-sensitive all-different constraint as section 4.2.3 of the dissertation has it. A choice x with
// the path condition p has a reserved value Q wherever p does not hold, here the lower end of its range; and
// solutions differ in a choice that exists. TracingEngine::exclude() does without path conditions.

/// For each choice of the trace: p or x = Q. To hold in all solutions.
std::vector<NodeId> reserved_values(Graph& graph, const Trace& trace);

/// p and x != s for each choice of the trace, s its value in the solution, or Q. One of them has to hold.
std::vector<NodeId> differences(Graph& graph, const Trace& trace,
                                const std::map<AddressId, std::int64_t>& solution);

}  // namespace solitaire
