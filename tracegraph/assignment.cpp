#include "tracegraph/assignment.h"

#include "tracegraph/post_order.h"

namespace solitaire {

std::optional<Scalar> folded(Op op, std::span<const std::optional<Scalar>> operands) {
  std::array<Scalar, 3> values{};
  bool defined = true;
  for (std::size_t i = 0; i < operands.size(); ++i) {
    defined = defined && operands[i].has_value();
    values[i] = operands[i].value_or(Scalar::of(false));
  }
  if (op == Op::kAnd || op == Op::kOr) {
    const bool settles = op == Op::kOr;
    for (const std::optional<Scalar>& each : operands) {
      if (each && (each->i != 0) == settles) return Scalar::of(settles);
    }
  } else if (is_ite(op) && operands[0]) {
    defined = operands[operands[0]->i != 0 ? 1 : 2].has_value();
  }
  if (!defined) return std::nullopt;
  return operation(op).fold(values.data());
}

Assignment::Assignment(const Graph& graph, std::function<Scalar(std::size_t)> value_of)
    : graph_(graph), value_of_(std::move(value_of)) {
  cover_graph();
}

void Assignment::cover_graph() {
  states_.resize(graph_.size());
  values_.resize(graph_.size(), Scalar::of(false));
}

std::optional<Scalar> Assignment::value(NodeId node) {
  if (node.index >= states_.size()) cover_graph();
  const auto push_needed = [this](NodeId at, std::vector<NodeId>& pending) {
    for (const NodeId operand : graph_.node(at).args()) {
      if (state(operand) == State::kUnknown) pending.push_back(operand);
    }
  };
  in_post_order(
      node, [this](NodeId at) { return state(at) != State::kUnknown; }, push_needed,
      [this](NodeId at) { compute(at); });
  if (state(node) == State::kUndefined) return std::nullopt;
  return values_[node.index];
}

bool Assignment::holds(NodeId node) {
  const auto known = value(node);
  return known && known->i != 0;
}

void Assignment::compute(NodeId id) {
  const Graph::Node& node = graph_.node(id);
  std::optional<Scalar> result;
  if (node.is_constant()) {
    result = graph_.scalar(id);
  } else if (is_choice(node.op)) {
    result = value_of_(node.payload);
  } else {
    std::array<std::optional<Scalar>, 3> operands;
    std::size_t count = 0;
    for (const NodeId operand : node.args()) {
      if (state(operand) == State::kKnown) operands[count] = values_[operand.index];
      ++count;
    }
    result = folded(node.op, {operands.data(), count});
  }
  states_[id.index] = result ? State::kKnown : State::kUndefined;
  if (result) values_[id.index] = *result;
}

}  // namespace solitaire
