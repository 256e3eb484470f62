#pragma once
#include <functional>
#include <vector>

#include "tracegraph/trace.h"

namespace solitaire {

/// Returns all that has to hold in an execution that ends well on the explored paths: that it fulfils the
/// requirements for which `firm` is true, or all of them, takes no closed side, and comes to no error.
std::vector<NodeId> requirements_of(Graph& graph, const Trace& trace,
                                    const std::function<bool(const Term&)>& firm = nullptr);

/// Returns the same without what keeps executions from closed sides.
std::vector<NodeId> requirements_of_any_path(Graph& graph, const Trace& trace,
                                             const std::function<bool(const Term&)>& firm = nullptr);

}  // namespace solitaire
