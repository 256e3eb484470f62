#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "tracegraph/graph.h"

namespace solitaire {

/// Says which nodes have a node as an operand, in a graph as it was when this was made.
class Users {
 public:
  explicit Users(const Graph& graph);

  /// Returns how many nodes the graph had.
  std::size_t size() const { return first_.size() - 1; }
  /// Returns the nodes that have this one as an operand, one of them several times if it has it so.
  std::span<const NodeId> of(NodeId node) const {
    return std::span(users_).subspan(first_[node.index], first_[node.index + 1] - first_[node.index]);
  }

 private:
  std::vector<std::uint32_t> first_;  // by node: where its users start; one more, for their end
  std::vector<NodeId> users_;
};

}  // namespace solitaire
