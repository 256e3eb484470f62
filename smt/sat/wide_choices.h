#pragma once
#include <cstddef>
#include <functional>
#include <vector>

#include "smt/sat/order_size.h"
#include "tracegraph/graph.h"

namespace solitaire {

/// Returns the variables of many values (tuning::kMostAlwaysOrdered) that are better written in bits, of the
/// choices from the node `first` of the graph on: those that are read in bits at least as often as by their
/// order.
///
/// An order has a literal for each value. That is worth it where the order is read, as by comparisons of
/// positions and by `distinct`, and only a burden to each decision where all that becomes of the choice is a
/// sum that is written in bits.
///
/// `size` gives the size of each node if all choices that can have an order have one.
std::vector<std::size_t> wide_choices_in_bits(const Graph& graph, std::uint32_t first,
                                              const std::function<OrderSize(NodeId)>& size);

}  // namespace solitaire
