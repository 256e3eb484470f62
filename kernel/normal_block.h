#pragma once
#include <cstddef>
#include <vector>

#include "kernel/known_forms.h"

namespace solitaire {

/// Floats of a trace that, given all else, have one normal distribution together: the density's logarithm is
/// a polynomial of the second degree in them. Each has a normal form by itself; `mixed` are the second
/// derivatives along two of them, as nodes that depend on none of them: of the second and the first, the
/// third and the first, the third and the second, and so on.
struct NormalBlock {
  std::vector<std::size_t> choices;  // of the trace, by their numbers, in ascending order
  std::vector<NodeId> mixed;
};

/// The block of a trace: of the floats with a normal form, unless they are many, the first that have such a
/// distribution together. Adds nodes to the graph.
NormalBlock normal_block(Graph& graph, const Trace& trace, const std::vector<KnownForm>& forms);

}  // namespace solitaire
