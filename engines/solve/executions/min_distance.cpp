#include "engines/solve/executions/min_distance.h"

#include <cmath>
#include <map>
#include <numeric>
#include <vector>

#include "tracegraph/sums.h"

namespace solitaire {
namespace {

std::vector<NodeId> nodes_of(const std::map<AddressId, NodeId>& conditions) {
  std::vector<NodeId> nodes;
  for (const auto& [address, condition] : conditions) nodes.push_back(condition);
  return nodes;
}

}  // namespace

DistanceBound DistanceBound::of(double bound) {
  constexpr std::int64_t kDigits = 1'000'000;
  const auto part = static_cast<std::int64_t>(std::llround(bound * static_cast<double>(kDigits)));
  const std::int64_t common = std::gcd(part, kDigits);
  return {part / common, kDigits / common};
}

bool DistanceBound::reached(const Overlap& overlap) const {
  const auto all = static_cast<std::int64_t>(overlap.all);
  return whole * static_cast<std::int64_t>(overlap.shared) <= (whole - part) * all;
}

NodeId far_from(Graph& graph, const Trace& trace, const Valuation& solution, const DistanceBound& bound) {
  // `shared` maps each address of the solution to the condition that an execution has the solution's value
  // there. `extra` maps each other address to the condition that an execution comes there.
  std::map<AddressId, NodeId> shared, extra;
  for (const TraceChoice& choice : trace.choices) {
    if (choice.auxiliary) continue;
    const auto known = solution.find(choice.address);
    NodeId condition = choice.guard;
    if (known != solution.end()) {
      const NodeId equal = graph.apply(Op::kEqInt, {choice.variable, graph.constant(known->second.as_int())});
      condition = graph.conjunction(condition, equal);
    }
    auto& conditions = known == solution.end() ? extra : shared;
    NodeId& any = conditions.try_emplace(choice.address, kFalse).first->second;
    any = graph.disjunction(any, condition);
  }
  const NodeId own = graph.constant(static_cast<std::int64_t>(solution.size()));
  const NodeId all = graph.apply(Op::kAdd, {own, count_of(graph, nodes_of(extra))});
  const std::int64_t rest = bound.whole - bound.part;
  const std::int64_t most = rest * graph.node(all).interval.hi / bound.whole;
  const NodeId count = count_of(graph, nodes_of(shared), most + 1);
  if (graph.node(all).is_constant()) return graph.apply(Op::kLeInt, {count, graph.constant(most)});
  return graph.apply(Op::kLeInt, {graph.apply(Op::kMul, {count, graph.constant(bound.whole)}),
                                  graph.apply(Op::kMul, {all, graph.constant(rest)})});
}

}  // namespace solitaire
