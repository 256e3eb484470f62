#pragma once
#include "tracegraph/trace.h"

namespace solitaire {

/// Returns by how much an execution misses the asserts of a trace, as an int node: 0 where all hold. The
/// number of broken conjuncts counts first, and then how far comparisons of ints are from holding: of x < 3,
/// x = 7 misses by 5. What is no comparison misses by 1. What no execution can avoid is left out. Throws
/// IntegerTooLarge.
NodeId miss_of(Graph& graph, const Trace& trace);

}  // namespace solitaire
