#include "tracegraph/assignment.h"

#include "tracegraph/post_order.h"

namespace solitaire {

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
    std::array<Scalar, 3> operands{};
    std::array<bool, 3> known{};
    std::size_t count = 0;
    for (const NodeId operand : node.args()) {
      known[count] = state(operand) == State::kKnown;
      operands[count++] = values_[operand.index];
    }
    // Of an ite only the side that is taken counts, and one operand may decide a connective by itself.
    bool defined = true;
    for (std::size_t i = 0; i < count; ++i) defined = defined && known[i];
    if (node.op == Op::kAnd || node.op == Op::kOr) {
      const bool settles = node.op == Op::kOr;
      for (std::size_t i = 0; i < count; ++i) {
        if (known[i] && (operands[i].i != 0) == settles) result = Scalar::of(settles);
      }
    } else if (count == 3 && known[0]) {
      defined = known[operands[0].i != 0 ? 1 : 2];
    }
    if (!result && defined) result = operation(node.op).fold(operands.data());
  }
  states_[id.index] = result ? State::kKnown : State::kUndefined;
  if (result) values_[id.index] = *result;
}

}  // namespace solitaire
