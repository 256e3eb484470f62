#pragma once
#include <map>
#include <vector>

#include "tracegraph/trace.h"

namespace solitaire {

/// Maps the number of each choice variable of a trace to the condition under which an execution meets a
/// choice that the variable stands for.
using MeetingConditions = std::map<std::size_t, NodeId>;
MeetingConditions meeting_conditions(Graph& graph, const Trace& trace);

/// Returns conditions by which a choice that an execution does not meet has its lowest value. Then each
/// execution is one assignment of the variables, and not as many as there are values of what it does not
/// meet.
std::vector<NodeId> fixed_unmet_choices(Graph& graph, const MeetingConditions& meeting);

}  // namespace solitaire
