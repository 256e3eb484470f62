#include "tracegraph/cone.h"

#include <algorithm>
#include <unordered_set>

namespace solitaire {

std::set<std::size_t> variables_below(const Graph& graph, std::span<const NodeId> nodes) {
  std::set<std::size_t> variables;
  std::unordered_set<NodeId> seen(nodes.begin(), nodes.end());
  std::vector<NodeId> pending(seen.begin(), seen.end());
  while (!pending.empty()) {
    const Graph::Node& node = graph.node(pending.back());
    pending.pop_back();
    if (is_choice(node.op)) variables.insert(node.payload);
    for (const NodeId operand : node.args()) {
      if (seen.insert(operand).second) pending.push_back(operand);
    }
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
