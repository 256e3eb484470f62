#include "solitaire/run/path_intervals.h"

namespace solitaire {
namespace {

/// The least and greatest value for which a comparison with a constant can hold.
Interval bounds_if(Op op, bool constant_left, std::int64_t constant, bool holds) {
  const std::int64_t most = kIntLimit;
  if (op == Op::kEqInt) return holds ? Interval{constant, constant} : Interval{-most, most};
  // constant < x, x < constant and their like, as a bound of x; what does not hold is the opposite bound.
  const bool strict = op == Op::kLtInt;
  if (constant_left == holds) return {constant + (strict == holds ? 1 : 0), most};
  return {-most, constant - (strict == holds ? 1 : 0)};
}

}  // namespace

std::optional<PathIntervals::Comparison> PathIntervals::comparison(NodeId condition) const {
  const Graph::Node& node = graph_->node(condition);
  if (node.op != Op::kEqInt && node.op != Op::kLtInt && node.op != Op::kLeInt) return std::nullopt;
  const bool left = graph_->node(node.operands[0]).op == Op::kConstInt;
  const bool right = graph_->node(node.operands[1]).op == Op::kConstInt;
  if (left == right) return std::nullopt;
  const NodeId constant = node.operands[left ? 0 : 1];
  return Comparison{node.operands[left ? 1 : 0], node.op, left, graph_->node(constant).interval.lo};
}

Interval PathIntervals::interval(NodeId node) const {
  for (std::size_t i = known_.size(); i-- > first_;) {
    if (known_[i].node == node) return known_[i].interval;
  }
  return graph_->node(node).interval;
}

void PathIntervals::narrow(NodeId node, Interval bounds) {
  const Interval before = interval(node);
  const Interval after{std::max(before.lo, bounds.lo), std::min(before.hi, bounds.hi)};
  if (after != before && after.lo <= after.hi) known_.push_back({node, after});
}

void PathIntervals::assume(NodeId condition, bool holds) {
  const Graph::Node& node = graph_->node(condition);
  if (node.op == Op::kNot) return assume(node.operands[0], !holds);
  if ((node.op == Op::kAnd && holds) || (node.op == Op::kOr && !holds)) {
    assume(node.operands[0], holds);
    assume(node.operands[1], holds);
    return;
  }
  const auto compared = comparison(condition);
  if (!compared) return;
  if (compared->op == Op::kEqInt && !holds) {  // only tells something at an end of the interval
    const Interval now = interval(compared->node);
    if (now.lo == compared->constant) narrow(compared->node, {now.lo + 1, now.hi});
    if (now.hi == compared->constant) narrow(compared->node, {now.lo, now.hi - 1});
    return;
  }
  narrow(compared->node, bounds_if(compared->op, compared->constant_left, compared->constant, holds));
}

std::optional<bool> PathIntervals::decide(NodeId condition) const {
  if (const Interval truth = graph_->node(condition).interval; truth.single()) return truth.lo != 0;
  if (known_.size() == first_) return std::nullopt;
  const Graph::Node& node = graph_->node(condition);
  if (node.op == Op::kNot) {
    const auto inner = decide(node.operands[0]);
    return inner ? std::optional(!*inner) : std::nullopt;
  }
  const auto compared = comparison(condition);
  if (!compared) return std::nullopt;
  const Interval now = interval(compared->node);
  for (const bool holds : {true, false}) {
    const Interval needed = bounds_if(compared->op, compared->constant_left, compared->constant, holds);
    if (disjoint(now, needed)) return !holds;
  }
  if (compared->op == Op::kEqInt && now.single() && now.lo == compared->constant) return true;
  return std::nullopt;
}

}  // namespace solitaire
