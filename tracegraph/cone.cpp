#include "tracegraph/cone.h"

#include <unordered_set>

namespace solitaire {

std::set<std::size_t> variables_below(const Graph& graph, std::span<const NodeId> nodes) {
  std::set<std::size_t> variables;
  std::unordered_set<NodeId> seen(nodes.begin(), nodes.end());
  std::vector<NodeId> pending(seen.begin(), seen.end());
  while (!pending.empty()) {
    const Graph::Node& node = graph.node(pending.back());
    pending.pop_back();
    if (node.op == Op::kChoice) variables.insert(node.payload);
    for (const NodeId operand : node.args()) {
      if (seen.insert(operand).second) pending.push_back(operand);
    }
  }
  return variables;
}

}  // namespace solitaire
