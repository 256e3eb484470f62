#include "tracegraph/sums.h"

namespace solitaire {

NodeId sum_of(Graph& graph, std::vector<NodeId> terms, std::int64_t cap) {
  if (terms.empty()) return graph.constant(std::int64_t{0});
  while (terms.size() > 1) {
    std::vector<NodeId> sums;
    for (std::size_t i = 0; i + 1 < terms.size(); i += 2) {
      const NodeId sum = graph.apply(Op::kAdd, {terms[i], terms[i + 1]});
      const bool small = graph.node(sum).interval.hi <= cap;
      sums.push_back(small ? sum : graph.apply(Op::kMin, {sum, graph.constant(cap)}));
    }
    if (terms.size() % 2 != 0) sums.push_back(terms.back());
    terms = std::move(sums);
  }
  return terms.front();
}

NodeId count_of(Graph& graph, const std::vector<NodeId>& conditions, std::int64_t cap) {
  const NodeId one = graph.constant(std::int64_t{1});
  const NodeId none = graph.constant(std::int64_t{0});
  std::vector<NodeId> counts;
  for (const NodeId condition : conditions) counts.push_back(graph.phi(condition, one, none));
  return sum_of(graph, std::move(counts), cap);
}

}  // namespace solitaire
