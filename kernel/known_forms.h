#pragma once
#include <span>
#include <vector>

#include "kernel/forms.h"
#include "tracegraph/trace.h"

namespace solitaire {

/// What of a trace counts, as nodes. The density's logarithm is the sum of the terms; what is required has to
/// hold, and what is assumed is the path.
struct Demands {
  std::vector<NodeId> terms;
  std::vector<NodeId> required;
  std::vector<NodeId> assumed;
};

/// The forms of the density along the trace's choices, in their order. Adds nodes to the graph.
std::vector<KnownForm> known_forms(Graph& graph, const Trace& trace, const Demands& demands);

/// Returns true if the parameters of the choice's distribution depend on no choice.
bool has_fixed_parameters(const Graph& graph, const TraceChoice& choice);

}  // namespace solitaire
