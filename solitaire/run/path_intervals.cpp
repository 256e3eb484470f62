#include "solitaire/run/path_intervals.h"

#include <algorithm>
#include <array>

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

std::size_t PathIntervals::last_fact(NodeId node) const {
  const auto last = last_.find(node);
  return last == last_.end() ? kNone : last->second;
}

/// Returns what facts about the node itself say. Facts that are hidden are older than all that are shown.
Interval PathIntervals::own_interval(NodeId node) const {
  const std::size_t last = last_fact(node);
  return last != kNone && last >= first_ ? known_[last].interval : graph_->node(node).interval;
}

/// Of x + 3, facts are about x as well, since the graph moves constants to the other side of a comparison.
Interval PathIntervals::interval(NodeId id) const {
  const Interval own = own_interval(id);
  const Graph::Node& node = graph_->node(id);
  if (node.op != Op::kAdd || !graph_->node(node.operands[1]).is_constant()) return own;
  const Interval moved = add(own_interval(node.operands[0]), graph_->node(node.operands[1]).interval);
  const Interval both{std::max(own.lo, moved.lo), std::min(own.hi, moved.hi)};
  return both.lo <= both.hi ? both : own;
}

void PathIntervals::narrow(NodeId node, Interval bounds) {
  const Interval before = interval(node);
  const Interval after{std::max(before.lo, bounds.lo), std::min(before.hi, bounds.hi)};
  if (after == before || after.lo > after.hi) return;
  known_.push_back({node, after, last_fact(node)});
  last_[node] = known_.size() - 1;
}

void PathIntervals::drop_from(std::size_t size) {
  while (known_.size() > size) {
    const Fact& last = known_.back();
    if (last.before == kNone) {
      last_.erase(last.node);
    } else {
      last_[last.node] = last.before;
    }
    known_.pop_back();
  }
}

void PathIntervals::derive(NodeId made) {
  if (known_.size() == first_) return;
  const Graph::Node& node = graph_->node(made);
  const auto bounds = operation(node.op).bounds;
  if (bounds == nullptr || node.args().empty()) return;
  std::array<Interval, 3> intervals;
  bool narrower = false;
  for (std::size_t i = 0; i < node.args().size(); ++i) {
    intervals[i] = interval(node.operands[i]);
    narrower = narrower || intervals[i] != graph_->node(node.operands[i]).interval;
  }
  if (narrower) narrow(made, bounds(intervals.data()));
}

/// Conditions share their parts, so each is looked at once, however many ways lead to it.
void PathIntervals::assume(NodeId condition, bool holds) {
  seen_.cover(*graph_);
  std::vector<std::pair<NodeId, bool>> pending{{condition, holds}};
  while (!pending.empty()) {
    const auto [at, at_holds] = pending.back();
    pending.pop_back();
    const Graph::Node& node = graph_->node(at);
    const bool is_conjunction = node.op == (at_holds ? Op::kAnd : Op::kOr);
    if (node.op == Op::kNot) {
      pending.emplace_back(node.operands[0], !at_holds);
    } else if (!is_conjunction) {
      assume_single(at, at_holds);
    } else if (seen_.meet(at, at_holds)) {
      pending.insert(pending.end(), {{node.operands[1], at_holds}, {node.operands[0], at_holds}});
    }
  }
  seen_.clear();
}

void PathIntervals::assume_single(NodeId condition, bool holds) {
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
  if (node.op != Op::kEqInt && node.op != Op::kLtInt && node.op != Op::kLeInt) return std::nullopt;
  const Interval a = interval(node.operands[0]), b = interval(node.operands[1]);
  if (node.op == Op::kEqInt) {
    if (disjoint(a, b)) return false;
    return a.single() && b.single() ? std::optional(true) : std::nullopt;
  }
  const std::int64_t least_gap = node.op == Op::kLtInt ? 1 : 0;
  if (a.hi + least_gap <= b.lo) return true;
  return a.lo + least_gap > b.hi ? std::optional(false) : std::nullopt;
}

}  // namespace solitaire
