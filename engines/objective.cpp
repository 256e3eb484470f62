#include "engines/objective.h"

#include <map>

namespace solitaire {
namespace {

/// A balanced tree, in which most sums are narrow.
NodeId sum(Graph& graph, std::vector<NodeId> terms) {
  if (terms.empty()) return graph.constant(std::int64_t{0});
  while (terms.size() > 1) {
    std::vector<NodeId> sums;
    for (std::size_t i = 0; i + 1 < terms.size(); i += 2)
      sums.push_back(graph.apply(Op::kAdd, {terms[i], terms[i + 1]}));
    if (terms.size() % 2 != 0) sums.push_back(terms.back());
    terms = std::move(sums);
  }
  return terms.front();
}

NodeId cost_of_wishes(Graph& graph, const Trace& trace) {
  const NodeId none = graph.constant(std::int64_t{0});
  std::vector<NodeId> costs;
  for (const TraceWish& wish : trace.wishes) costs.push_back(graph.phi(wish.guard, wish.cost, none));
  return sum(graph, std::move(costs));
}

/// An assert is broken once, however many of its conjuncts are.
NodeId broken_asserts(Graph& graph, const Trace& trace) {
  std::map<std::tuple<AddressId, std::uint32_t, std::uint32_t>, NodeId> broken;
  for (const TraceAssert& part : trace.asserts) {
    if (part.requirement != Requirement::kAssert) continue;
    const auto key = std::tuple(part.address, part.whole.source, part.whole.begin);
    NodeId& whole = broken.try_emplace(key, kFalse).first->second;
    whole = graph.disjunction(whole, graph.conjunction(part.guard, graph.negation(part.condition)));
  }
  std::vector<NodeId> counts;
  for (const auto& [key, condition] : broken) {
    counts.push_back(graph.phi(condition, graph.constant(std::int64_t{1}), graph.constant(std::int64_t{0})));
  }
  return sum(graph, std::move(counts));
}

}  // namespace

NodeId objective_of(Graph& graph, const Trace& trace, bool relax) {
  const NodeId cost = cost_of_wishes(graph, trace);
  if (!relax) return cost;
  const Interval wishes = graph.node(cost).interval;
  const NodeId weight = graph.constant(wishes.hi - wishes.lo + 1);
  return graph.apply(Op::kAdd, {graph.apply(Op::kMul, {broken_asserts(graph, trace), weight}), cost});
}

}  // namespace solitaire
