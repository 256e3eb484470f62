#pragma once
#include "tracegraph/trace.h"

namespace solitaire {

/// What the wishes of a trace cost an execution, as an int node; above them, with `relax`, how many asserts
/// are broken: one more of them costs more than all wishes can.
/// Throws IntegerTooLarge.
NodeId objective_of(Graph& graph, const Trace& trace, bool relax);

}  // namespace solitaire
