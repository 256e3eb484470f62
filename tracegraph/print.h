#pragma once
#include <string>

#include "tracegraph/trace.h"

namespace solitaire {

/// The trace as text, an operation a line in the manner of figure 4.3: operations named x0, x1, ... in the
/// order of evaluation, then what must hold, what was not explored, and the program's result.
std::string trace_text(const Graph& graph, const AddressTable& addresses, const Trace& trace,
                       const std::string& result);

/// The graph of operations below the trace's guards and conditions, for Graphviz.
std::string trace_dot(const Graph& graph, const AddressTable& addresses, const Trace& trace);

}  // namespace solitaire
