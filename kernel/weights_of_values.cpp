#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <unordered_map>

#include "kernel/combination.h"
#include "kernel/forms.h"
#include "kernel/machine.h"

namespace solitaire {
namespace {

/// So many operations are written for one choice at most: for longer ones it pays to have the same code for
/// all values.
constexpr std::size_t kMostOperationsWritten = 2000;

/// The trace behind a choice, as it is where the choice has a certain value.
class Substitution {
 public:
  Substitution(Graph& graph, NodeId choice, std::int64_t value, const Reach& reach) : graph_(graph) {
    made_.emplace(choice.index, graph.constant(value));
    for (const std::uint32_t node : reach.nodes)
      if (node != choice.index) made_.emplace(node, made_by({node}));
  }
  NodeId operator[](NodeId node) const {
    const auto found = made_.find(node.index);
    return found == made_.end() ? node : found->second;
  }

 private:
  /// Of constants it is what the machine would make of them, so that nothing is undefined.
  NodeId made_by(NodeId id) {
    const Graph::Node node = graph_.node(id);  // a copy: the graph grows meanwhile
    const std::size_t arity = node.args().size();
    std::array<NodeId, 3> operands{};
    std::array<Scalar, 4> cells{};
    bool constant = true;
    for (std::size_t i = 0; i < arity; ++i) {
      operands[i] = (*this)[node.operands[i]];
      constant = constant && graph_.node(operands[i]).is_constant();
      if (constant) cells[i] = graph_.scalar(operands[i]);
    }
    if (constant) {
      const Instruction step{node.op, 3, {0, 1, 2}};
      run(std::span(&step, 1), cells.data());
      return graph_.constant(node.type(), cells[3]);
    }
    if (arity == 1) return graph_.apply(node.op, {operands[0]});
    if (arity == 2) return graph_.apply(node.op, {operands[0], operands[1]});
    return graph_.apply(node.op, {operands[0], operands[1], operands[2]});
  }

  Graph& graph_;
  std::unordered_map<std::uint32_t, NodeId> made_;
};

/// Leaves out what all have in common, which is among the parts of the first.
void drop_common(std::vector<Combination>& weights) {
  const auto same = [](const Combination::Part& a, const Combination::Part& b) {
    return a.factors == b.factors && a.times == b.times;
  };
  std::vector<Combination::Part> common = weights[0].parts();
  std::erase_if(common, [&](const Combination::Part& part) {
    return !std::all_of(weights.begin() + 1, weights.end(), [&](Combination& each) {
      return std::any_of(each.parts().begin(), each.parts().end(),
                         [&](const auto& other) { return same(part, other); });
    });
  });
  for (Combination& each : weights)
    std::erase_if(each.parts(), [&](const Combination::Part& part) {
      return std::any_of(common.begin(), common.end(), [&](const auto& other) { return same(part, other); });
    });
}

bool can_be_substituted(const Graph& graph, const Reach& reach) {
  return std::none_of(reach.nodes.begin(), reach.nodes.end(),
                      [&](std::uint32_t node) { return graph.node({node}).op == Op::kFloor; });
}

}  // namespace

std::optional<KnownForm> weights_of_values(Graph& graph, NodeId choice, const Distribution& distribution,
                                           const Reach& reach) {
  const std::uint64_t size = distribution.size();
  if (size * reach.nodes.size() > kMostOperationsWritten || !can_be_substituted(graph, reach))
    return std::nullopt;
  std::vector<Combination> weights;
  std::vector<NodeId> possible;
  for (std::uint64_t i = 0; i < size; ++i) {
    const Substitution made(graph, choice, distribution.value(i), reach);
    Combination& weight = weights.emplace_back();
    for (const NodeId term : reach.terms) weight.add(Combination(graph, made[term]));
    weight.settle();
    possible.push_back(kTrue);
    for (const NodeId condition : reach.required)
      possible.back() = graph.conjunction(possible.back(), made[condition]);
  }
  drop_common(weights);
  KnownForm known{Form::kWeights, {}};
  const NodeId never = graph.constant(-std::numeric_limits<double>::infinity());
  for (std::uint64_t i = 0; i < size; ++i)
    known.numbers.push_back(graph.phi(possible[i], weights[i].node(graph), never));
  return known;
}

}  // namespace solitaire
