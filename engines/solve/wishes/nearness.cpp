#include "engines/solve/wishes/nearness.h"

#include <map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "tracegraph/sums.h"

namespace solitaire {
namespace {

/// What is further from holding than it can be at its nearest, by more than this, is as bad as this: the
/// numbers stay small, and near is near.
constexpr std::int64_t kFurthest = 255;

/// Makes nodes that say how far conditions are from holding, each once.
class Misses {
 public:
  explicit Misses(Graph& graph) : graph_(graph) {}

  /// How far the node is from being `wanted`.
  NodeId of(NodeId node, bool wanted) {
    const auto [place, is_new] = known_.try_emplace({node.index, wanted}, kFalse);
    if (!is_new) return place->second;
    const NodeId made = make(node, wanted);
    return known_[{node.index, wanted}] = made;
  }

 private:
  NodeId constant(std::int64_t value) { return graph_.constant(value); }
  NodeId at_most_furthest(NodeId miss) {
    return graph_.apply(Op::kMin, {miss, constant(graph_.node(miss).interval.lo + kFurthest)});
  }
  NodeId both(NodeId a, NodeId b) { return at_most_furthest(graph_.apply(Op::kAdd, {a, b})); }
  NodeId either(NodeId a, NodeId b) { return graph_.apply(Op::kMin, {a, b}); }

  /// By how much a - b is above `most`.
  NodeId above(NodeId a, NodeId b, std::int64_t most) {
    const NodeId by = graph_.apply(Op::kSub, {graph_.apply(Op::kSub, {a, b}), constant(most)});
    return at_most_furthest(graph_.apply(Op::kMax, {by, constant(0)}));
  }

  NodeId make(NodeId node, bool wanted) {
    const Graph::Node made = graph_.node(node);  // a copy: the graph grows meanwhile
    const auto operand = [&](std::size_t i) { return made.operands[i]; };
    switch (made.op) {
      case Op::kNot:
        return of(operand(0), !wanted);
      case Op::kAnd:
      case Op::kOr: {
        const NodeId a = of(operand(0), wanted), b = of(operand(1), wanted);
        return (made.op == Op::kAnd) == wanted ? both(a, b) : either(a, b);
      }
      case Op::kIteBool:
        return graph_.phi(operand(0), of(operand(1), wanted), of(operand(2), wanted));
      case Op::kLeInt:
        return wanted ? above(operand(0), operand(1), 0) : above(operand(1), operand(0), -1);
      case Op::kLtInt:
        return wanted ? above(operand(0), operand(1), -1) : above(operand(1), operand(0), 0);
      case Op::kEqInt:
        if (wanted)
          return at_most_furthest(graph_.apply(Op::kAbs, {graph_.apply(Op::kSub, {operand(0), operand(1)})}));
        break;
      default:
        break;
    }
    return graph_.phi(node, constant(wanted ? 0 : 1), constant(wanted ? 1 : 0));
  }

  Graph& graph_;
  std::map<std::pair<std::uint32_t, bool>, NodeId> known_;
};

/// Returns the conjuncts of a condition.
std::vector<NodeId> flattened(const Graph& graph, NodeId condition) {
  std::vector<NodeId> pending{condition}, found;
  std::unordered_set<NodeId> seen;
  while (!pending.empty()) {
    const NodeId node = pending.back();
    pending.pop_back();
    if (node == kTrue || !seen.insert(node).second) continue;
    if (graph.node(node).op == Op::kAnd) {
      const auto operands = graph.node(node).args();
      pending.insert(pending.end(), operands.begin(), operands.end());
    } else {
      found.push_back(node);
    }
  }
  return found;
}

}  // namespace

NodeId miss_of(Graph& graph, const Trace& trace) {
  Misses misses(graph);
  std::vector<NodeId> amounts, broken;
  const NodeId none = graph.constant(std::int64_t{0});
  for (const Term& part : trace.hard_terms) {
    if (part.requirement != ConstraintKind::kAssert) continue;
    for (const NodeId conjunct : flattened(graph, part.node)) {
      const NodeId miss = misses.of(conjunct, true);
      const NodeId avoidable = graph.apply(Op::kSub, {miss, graph.constant(graph.node(miss).interval.lo)});
      amounts.push_back(graph.phi(part.guard, avoidable, none));
      broken.push_back(graph.conjunction(part.guard, graph.negation(conjunct)));
    }
  }
  const NodeId weight = graph.constant(kFurthest * static_cast<std::int64_t>(amounts.size()) + 1);
  const NodeId count = graph.apply(Op::kMul, {count_of(graph, broken), weight});
  return graph.apply(Op::kAdd, {count, sum_of(graph, std::move(amounts))});
}

}  // namespace solitaire
