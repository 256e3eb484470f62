#pragma once
#include "tracegraph/trace.h"

namespace solitaire {

/// Returns what the wishes of a trace cost an execution, as an int node. With `relax` the number of broken
/// asserts is added, weighted so that one more of them costs more than all wishes can.
/// Throws IntegerTooLarge.
NodeId objective_of(Graph& graph, const Trace& trace, bool relax);

}  // namespace solitaire
