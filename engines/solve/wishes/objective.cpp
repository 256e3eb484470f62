#include "engines/solve/wishes/objective.h"

#include <map>

#include "tracegraph/sums.h"

namespace solitaire {
namespace {

NodeId cost_of_wishes(Graph& graph, const Trace& trace) {
  const NodeId none = graph.constant(std::int64_t{0});
  std::vector<NodeId> costs;
  for (const Term& term : trace.soft_terms) {
    if (term.strength == Term::Strength::kCost) costs.push_back(graph.phi(term.guard, term.node, none));
  }
  return sum_of(graph, std::move(costs));
}

/// An assert is broken once, however many of its conjuncts are.
NodeId broken_asserts(Graph& graph, const Trace& trace) {
  std::map<std::tuple<AddressId, std::uint32_t, std::uint32_t>, NodeId> broken;
  for (const Term& part : trace.hard_terms) {
    if (part.requirement != ConstraintKind::kAssert) continue;
    const auto key = std::tuple(part.address, part.whole.source, part.whole.begin);
    NodeId& whole = broken.try_emplace(key, kFalse).first->second;
    whole = graph.disjunction(whole, graph.conjunction(part.guard, graph.negation(part.node)));
  }
  std::vector<NodeId> conditions;
  for (const auto& [key, condition] : broken) conditions.push_back(condition);
  return count_of(graph, conditions);
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
