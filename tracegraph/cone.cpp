#include "tracegraph/cone.h"

#include <algorithm>
#include <unordered_set>

namespace solitaire {

std::vector<NodeId> nodes_below(const Graph& graph, std::span<const NodeId> roots) {
  std::unordered_set<NodeId> seen(roots.begin(), roots.end());
  std::vector<NodeId> nodes(seen.begin(), seen.end());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    for (const NodeId operand : graph.node(nodes[i]).args()) {
      if (seen.insert(operand).second) nodes.push_back(operand);
    }
  }
  return nodes;
}

std::set<std::size_t> variables_below(const Graph& graph, std::span<const NodeId> nodes) {
  std::set<std::size_t> variables;
  for (const NodeId id : nodes_below(graph, nodes)) {
    const Graph::Node& node = graph.node(id);
    if (is_choice(node.op)) variables.insert(node.payload);
  }
  return variables;
}

std::vector<NodeId> conjuncts(const Graph& graph, std::vector<NodeId> pending) {
  std::vector<NodeId> found;
  std::vector<bool> seen(graph.size(), false);
  while (!pending.empty()) {
    const NodeId node = pending.back();
    pending.pop_back();
    if (node == kTrue || seen[node.index]) continue;
    seen[node.index] = true;
    if (graph.node(node).op == Op::kAnd) {
      for (const NodeId operand : graph.node(node).args()) pending.push_back(operand);
    } else {
      found.push_back(node);
    }
  }
  std::reverse(found.begin(), found.end());
  return found;
}

}  // namespace solitaire
