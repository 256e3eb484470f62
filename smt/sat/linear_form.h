#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "smt/sat/order_size.h"
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

/// Returns false for most comparisons of which ordered_difference_form() returns nothing, without looking
/// far.
bool may_have_form(const Graph& graph, NodeId a, NodeId b);
/// Returns b - a as a linear form, if a comparison of the two is best read as one of sums: one of them at
/// least is arithmetic, and there are enough terms, all of which can be ordered. `size` gives the size of a
/// node in order encoding.
std::optional<LinearForm> ordered_difference_form(const Graph& graph, NodeId a, NodeId b,
                                                  const std::function<OrderSize(NodeId)>& size);

}  // namespace solitaire
