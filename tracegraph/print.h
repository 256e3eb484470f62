#pragma once
#include <functional>
#include <string>

#include "tracegraph/trace.h"

namespace solitaire {

/// Returns the name of a node in the text.
using NodeNames = std::function<std::string(NodeId)>;

/// The trace as text, an operation a line in the manner of figure 4.3: operations named x0, x1, ... in the
/// order of evaluation, then what must hold, what was not explored, and what the program returns. `result`
/// writes the last, given what nodes are called.
std::string trace_text(const Graph& graph, const AddressTable& addresses, const Trace& trace,
                       const std::function<std::string(const NodeNames&)>& result);

/// The graph of operations below the trace's guards and conditions, for Graphviz.
std::string trace_dot(const Graph& graph, const AddressTable& addresses, const Trace& trace);

}  // namespace solitaire
