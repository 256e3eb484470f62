#pragma once
#include <map>
#include <vector>

#include "tracegraph/trace.h"

namespace solitaire {

/// The choice variables of a trace, by their numbers, each with the condition under which an execution meets
/// it.
using MetChoices = std::map<std::size_t, NodeId>;
MetChoices met_choices(Graph& graph, const Trace& trace);

/// That a choice which an execution does not meet has its lowest value. Then each execution is one assignment
/// of the variables, and not as many as there are values of what it does not meet.
std::vector<NodeId> fixed_unmet_choices(Graph& graph, const MetChoices& met);

}  // namespace solitaire
