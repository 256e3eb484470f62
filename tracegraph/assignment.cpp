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
  if (state(node) == State::kUnknown) evaluate(node);
  if (state(node) == State::kUndefined) return std::nullopt;
  return values_[node.index];
}

void Assignment::evaluate(NodeId node) {
  const auto push_needed = [this](NodeId at, std::vector<NodeId>& pending) {
    for (const NodeId operand : graph_.node(at).args()) {
      if (state(operand) == State::kUnknown) pending.push_back(operand);
    }
  };
  in_post_order(
      node, [this](NodeId at) { return state(at) != State::kUnknown; }, push_needed,
      [this](NodeId at) { compute(at); });
}

void Assignment::cover_users() {
  if (users_.groups() == graph_.size()) return;
  users_ = {graph_.size(), [this](const auto& put) {
              for (std::uint32_t at = 0; at < graph_.size(); ++at) {
                for (const NodeId operand : graph_.node({at}).args()) put(operand.index, NodeId{at});
              }
            }};
}

void Assignment::take_changes() {
  cover_graph();
  cover_users();
  for (std::size_t number = 0; number < graph_.variables().size(); ++number) {
    const NodeId variable = graph_.variable_node(number);
    if (state(variable) == State::kKnown && value_of_(number).i != values_[variable.index].i)
      forget(variable);
  }
}

/// Forgets the values of a node and of what depends on it. What depends on a node that is unknown already is
/// unknown, too, as operands are evaluated first.
void Assignment::forget(NodeId node) {
  pending_.assign(1, node);
  while (!pending_.empty()) {
    const NodeId at = pending_.back();
    pending_.pop_back();
    if (state(at) == State::kUnknown) continue;
    states_[at.index] = State::kUnknown;
    const std::span<const NodeId> users = users_.of(at.index);
    pending_.insert(pending_.end(), users.begin(), users.end());
  }
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
