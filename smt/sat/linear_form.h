#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "tracegraph/graph.h"

namespace solitaire {

/// A sum of multiples of int nodes, each of which is no sum, difference or multiple itself, and a constant.
struct LinearForm {
  std::vector<std::pair<NodeId, std::int64_t>> terms;  // with their factors, which are not 0
  std::int64_t constant = 0;
};

/// Returns b - a as a linear form, or nothing if it has more terms than `most` or could come near the ends of
/// 64 bits. The work is that of visiting each node once, however often it is used.
std::optional<LinearForm> difference_form(const Graph& graph, NodeId a, NodeId b, std::size_t most);

}  // namespace solitaire
