#pragma once
#include <cstdint>
#include <unordered_map>

#include "smt/sat/choice_encoding.h"
#include "smt/sat/order_size.h"
#include "smt/sat/sparse_table.h"
#include "tracegraph/graph.h"

namespace solitaire {

/// Knows which ints of a trace graph can be written in order encoding, and how many values they have then.
class OrderSizes {
 public:
  OrderSizes(const Graph& graph, ChoiceEncoding& choices) : graph_(graph), choices_(choices) {}

  /// Finds the sizes of the nodes that are new in the graph. Choices of many values that are better written
  /// in bits have none, which `choices` is told. Returns true if there are new nodes.
  bool meet_new_nodes();

  OrderSize of(NodeId node) const {
    const OrderSize* size = sizes_.find(node.index);
    return size != nullptr ? *size : OrderSize{};
  }
  bool are_ordered(NodeId a, NodeId b) const { return of(a).is_ordered() && of(b).is_ordered(); }

 private:
  friend struct OrderSizings;

  void count_comparisons(std::uint32_t first);
  void find_sizes(std::uint32_t first);
  OrderSize computed(NodeId id) const;
  Interval interval(NodeId node) const { return graph_.node(node).interval; }
  Sized sized(NodeId node) const { return {of(node), interval(node)}; }

  const Graph& graph_;
  ChoiceEncoding& choices_;
  SparseTable<OrderSize> sizes_;                                  // by node; most are no ints
  std::unordered_map<std::uint32_t, std::uint32_t> comparisons_;  // by sum: how many compare it
};

}  // namespace solitaire
