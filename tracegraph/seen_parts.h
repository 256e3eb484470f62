#pragma once
#include <cstddef>
#include <vector>

#include "tracegraph/graph.h"

namespace solitaire {

/// Remembers which parts of conditions a walk has met, each with whether it holds, so that the walk meets
/// each once, however many ways lead to it.
class SeenParts {
 public:
  /// Makes room for the nodes that the graph has by now.
  void cover(const Graph& graph) { seen_.resize(2 * graph.size()); }
  /// Returns true if the part had not been met since clear().
  bool meet(NodeId node, bool holds) {
    const std::size_t number = 2 * std::size_t{node.index} + (holds ? 1 : 0);
    if (seen_[number]) return false;
    seen_[number] = true;
    met_.push_back(number);
    return true;
  }
  /// Takes time by what was met, and not by the size of the graph.
  void clear() {
    for (const std::size_t number : met_) seen_[number] = false;
    met_.clear();
  }

 private:
  std::vector<bool> seen_;
  std::vector<std::size_t> met_;
};

}  // namespace solitaire
