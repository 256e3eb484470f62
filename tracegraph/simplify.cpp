// The identities that Graph::apply knows. Each returns the simpler node, or nothing.
#include "tracegraph/graph.h"

namespace solitaire {

bool Graph::opposite(NodeId a, NodeId b) const {
  return (node(a).op == Op::kNot && node(a).operands[0] == b) ||
         (node(b).op == Op::kNot && node(b).operands[0] == a);
}

bool Graph::is_int(NodeId id, std::int64_t value) const {
  return node(id).op == Op::kConstInt && node(id).interval.lo == value;
}

namespace {

/// Makes a comparison of an int with a constant one of the sides among which the int is chosen, where the
/// intervals of some of these settle theirs: if(c, x - y, 1) <= 0 is c and x <= y. So a comparison that means
/// an int itself is about it, as if it stood alone.
class ComparedSides {
 public:
  /// The constant stands on the left if `on_left`.
  ComparedSides(Graph& graph, Op op, NodeId constant, bool on_left)
      : graph_(graph), op_(op), constant_(constant), on_left_(on_left) {}

  /// Returns nothing where no side is settled, or one is chosen very deep.
  std::optional<NodeId> of(NodeId id, unsigned depth = 0) {
    const Graph::Node node = graph_.node(id);  // a copy: the graph grows meanwhile
    if (node.op != Op::kIteInt || depth == kMostDepth) return std::nullopt;
    if (!is_settled(node.operands[1]) && !is_settled(node.operands[2])) return std::nullopt;
    const auto a = of_side(node.operands[1], depth);
    if (!a) return std::nullopt;
    const auto b = of_side(node.operands[2], depth);
    if (!b) return std::nullopt;
    return graph_.apply(Op::kIteBool, {node.operands[0], *a, *b});
  }

 private:
  static constexpr unsigned kMostDepth = 40;

  bool is_settled(NodeId side) const {
    const Interval left = on_left_ ? interval(constant_) : interval(side);
    const Interval right = on_left_ ? interval(side) : interval(constant_);
    return op_ == Op::kLtInt ? left.hi < right.lo || left.lo >= right.hi
                             : left.hi <= right.lo || left.lo > right.hi;
  }
  Interval interval(NodeId id) const { return graph_.node(id).interval; }

  std::optional<NodeId> of_side(NodeId side, unsigned depth) {
    const Graph::Node node = graph_.node(side);
    const bool goes_on = node.op == Op::kIteInt && !is_settled(side) &&
                         (is_settled(node.operands[1]) || is_settled(node.operands[2]));
    if (goes_on) return of(side, depth + 1);
    return on_left_ ? graph_.apply(op_, {constant_, side}) : graph_.apply(op_, {side, constant_});
  }

  Graph& graph_;
  Op op_;
  NodeId constant_;
  bool on_left_;
};

std::optional<NodeId> compare_sides(Graph& graph, Op op, NodeId a, NodeId b) {
  if (graph.node(b).is_constant()) return ComparedSides(graph, op, b, false).of(a);
  if (graph.node(a).is_constant()) return ComparedSides(graph, op, a, true).of(b);
  return std::nullopt;
}

}  // namespace

std::optional<NodeId> Graph::simplify(Op op, std::span<const NodeId> args) {
  const auto interval = [&](std::size_t i) { return node(args[i]).interval; };
  switch (op) {
    case Op::kNot:
      if (node(args[0]).op == Op::kNot) return node(args[0]).operands[0];
      return std::nullopt;
    case Op::kAnd:
      return simplify_and(args[0], args[1]);
    case Op::kOr:
      return simplify_or(args[0], args[1]);
    case Op::kEqBool:
      if (args[0] == args[1]) return kTrue;
      if (opposite(args[0], args[1])) return kFalse;
      if (args[0] == kTrue) return args[1];
      if (args[1] == kTrue) return args[0];
      if (args[0] == kFalse) return negation(args[1]);
      if (args[1] == kFalse) return negation(args[0]);
      return std::nullopt;
    case Op::kIteBool:
    case Op::kIteInt:
    case Op::kIteFloat:
      return simplify_ite(op, args[0], args[1], args[2]);
    case Op::kAdd:
      return simplify_add(args[0], args[1]);
    case Op::kSub:
      if (args[0] == args[1]) return constant(std::int64_t{0});
      if (node(args[1]).is_constant()) return apply(Op::kAdd, {args[0], constant(-interval(1).lo)});
      return std::nullopt;
    case Op::kMul:
      if (is_int(args[0], 1)) return args[1];
      if (is_int(args[1], 1)) return args[0];
      return std::nullopt;
    case Op::kDiv:
      if (is_int(args[1], 1)) return args[0];
      return std::nullopt;
    case Op::kMin:
      if (args[0] == args[1] || interval(0).hi <= interval(1).lo) return args[0];
      if (interval(1).hi <= interval(0).lo) return args[1];
      return std::nullopt;
    case Op::kMax:
      if (args[0] == args[1] || interval(0).lo >= interval(1).hi) return args[0];
      if (interval(1).lo >= interval(0).hi) return args[1];
      return std::nullopt;
    case Op::kAbs:
      if (interval(0).lo >= 0) return args[0];
      return std::nullopt;
    case Op::kEqInt:
      return simplify_equal(args[0], args[1]);
    case Op::kLtInt:
      if (interval(0).hi < interval(1).lo) return kTrue;
      if (args[0] == args[1] || interval(0).lo >= interval(1).hi) return kFalse;
      if (const auto sides = compare_sides(*this, op, args[0], args[1])) return sides;
      return move_offset(op, args[0], args[1]);
    case Op::kLeInt:
      if (args[0] == args[1] || interval(0).hi <= interval(1).lo) return kTrue;
      if (interval(0).lo > interval(1).hi) return kFalse;
      if (const auto sides = compare_sides(*this, op, args[0], args[1])) return sides;
      return move_offset(op, args[0], args[1]);
    default:
      return std::nullopt;
  }
}

/// x + 0 is x, and (x + 1) + 2 is x + 3; the constant stands on the right.
std::optional<NodeId> Graph::simplify_add(NodeId a, NodeId b) {
  if (node(a).is_constant()) std::swap(a, b);
  if (!node(b).is_constant()) return std::nullopt;
  if (is_int(b, 0)) return a;
  const Node inner = node(a);
  if (inner.op != Op::kAdd || !node(inner.operands[1]).is_constant()) return std::nullopt;
  const std::int64_t offset = node(inner.operands[1]).interval.lo + node(b).interval.lo;
  if (!is_exact(offset)) return std::nullopt;
  return apply(Op::kAdd, {inner.operands[0], constant(offset)});
}

/// x + 2 < 5 is x < 3, and x - y < 5 is x < y + 5: comparisons are about the variables themselves.
std::optional<NodeId> Graph::move_offset(Op op, NodeId a, NodeId b) {
  const auto moved = [this](NodeId sum, NodeId limit) -> std::optional<std::pair<NodeId, NodeId>> {
    const Node inner = node(sum);
    if (inner.op != Op::kAdd || !node(inner.operands[1]).is_constant() || !node(limit).is_constant())
      return std::nullopt;
    const std::int64_t rest = node(limit).interval.lo - node(inner.operands[1]).interval.lo;
    if (!is_exact(rest)) return std::nullopt;
    return std::pair(inner.operands[0], constant(rest));
  };
  if (const auto left = moved(a, b)) return apply(op, {left->first, left->second});
  if (const auto right = moved(b, a)) return apply(op, {right->second, right->first});
  const auto is_difference = [this](NodeId difference, NodeId limit) {
    if (node(difference).op != Op::kSub || !node(limit).is_constant()) return false;
    const Interval subtracted = node(node(difference).operands[1]).interval;
    const std::int64_t by = node(limit).interval.lo;
    return is_exact(subtracted.lo + by) && is_exact(subtracted.hi + by);
  };
  if (is_difference(a, b)) {
    const auto [x, y, unused] = node(a).operands;
    return apply(op, {x, apply(Op::kAdd, {y, b})});
  }
  if (is_difference(b, a)) {
    const auto [x, y, unused] = node(b).operands;
    return apply(op, {apply(Op::kAdd, {y, a}), x});
  }
  return std::nullopt;
}

/// Returns true if the two compare the same int with different constants.
static bool are_of_different_values(const Graph& graph, const Graph::Node& a, const Graph::Node& b) {
  return a.op == Op::kEqInt && b.op == Op::kEqInt && a.operands[0] == b.operands[0] &&
         a.operands[1] != b.operands[1] && graph.node(a.operands[1]).is_constant() &&
         graph.node(b.operands[1]).is_constant();
}

std::optional<NodeId> Graph::simplify_and(NodeId a, NodeId b) {
  if (a == kFalse || b == kFalse || opposite(a, b)) return kFalse;
  if (a == kTrue || a == b) return b;
  if (b == kTrue) return a;
  // x == 1 and x != 2 is x == 1; x == 1 and x == 2 is false. Where one of several texts is chosen, each is
  // there where the index is its own and none of the others.
  const Node &first = node(a), &second = node(b);
  const bool differs_first = first.op == Op::kNot, differs_second = second.op == Op::kNot;
  if (differs_first && differs_second) return std::nullopt;
  if (!are_of_different_values(*this, differs_first ? node(first.operands[0]) : first,
                               differs_second ? node(second.operands[0]) : second))
    return std::nullopt;
  if (differs_first) return b;
  return differs_second ? a : kFalse;
}

std::optional<NodeId> Graph::simplify_or(NodeId a, NodeId b) {
  if (a == kTrue || b == kTrue || opposite(a, b)) return kTrue;
  if (a == kFalse || a == b) return b;
  if (b == kFalse) return a;
  // (g and c) or (g and not c) is g: what two sides of a branch become where they join again.
  if (node(a).op == Op::kAnd && node(b).op == Op::kAnd) {
    const auto& x = node(a).operands;
    const auto& y = node(b).operands;
    for (std::size_t i = 0; i < 2; ++i) {
      for (std::size_t j = 0; j < 2; ++j) {
        if (x[i] == y[j] && opposite(x[1 - i], y[1 - j])) return x[i];
      }
    }
  }
  return std::nullopt;
}

std::optional<NodeId> Graph::simplify_ite(Op op, NodeId condition, NodeId a, NodeId b) {
  if (const Interval truth = node(condition).interval; truth.single()) return truth.lo != 0 ? a : b;
  if (a == b) return a;
  if (node(condition).op == Op::kNot) return apply(op, {node(condition).operands[0], b, a});
  if (node(a).op == op && node(a).operands[0] == condition)
    return apply(op, {condition, node(a).operands[1], b});
  if (node(b).op == op && node(b).operands[0] == condition)
    return apply(op, {condition, a, node(b).operands[2]});
  if (op != Op::kIteBool) return std::nullopt;
  if (a == kTrue || a == condition) return disjunction(condition, b);
  if (a == kFalse) return conjunction(negation(condition), b);
  if (b == kFalse || b == condition) return conjunction(condition, a);
  if (b == kTrue) return disjunction(negation(condition), a);
  return std::nullopt;
}

namespace {

/// Makes the condition that a choice among constants is one of them: a condition on what decides the choice.
/// A list of a million numbers of which a thousand are 500 leaves some thousand comparisons of the index, and
/// nothing of the numbers.
class EqualToConstant {
 public:
  EqualToConstant(Graph& graph, NodeId constant) : graph_(graph), constant_(constant) {}

  /// Returns nothing for what is no choice among constants, or a deep or very large one.
  std::optional<NodeId> of(NodeId id, unsigned depth = 0) {
    const Graph::Node node = graph_.node(id);  // a copy: the graph grows meanwhile
    if (node.is_constant()) return graph_.constant(id == constant_);
    if (node.op != Op::kIteInt || depth == kMostDepth || ++visits_ == kMostVisits) return std::nullopt;
    if (!node.interval.contains(graph_.node(constant_).interval.lo)) return kFalse;
    if (const auto place = place_of(node)) return of_list(id, place->index, depth);
    const auto a = of(node.operands[1], depth + 1);
    if (!a) return std::nullopt;
    const auto b = of(node.operands[2], depth + 1);
    if (!b) return std::nullopt;
    return graph_.apply(Op::kIteBool, {node.operands[0], *a, *b});
  }

 private:
  /// A condition that an index is the place of an element.
  struct Place {
    NodeId index;
    std::int64_t number;
  };

  std::optional<Place> place_of(const Graph::Node& node) const {
    if (node.op != Op::kIteInt) return std::nullopt;
    const Graph::Node& condition = graph_.node(node.operands[0]);
    if (condition.op != Op::kEqInt || !graph_.node(condition.operands[1]).is_constant()) return std::nullopt;
    return Place{condition.operands[0], graph_.node(condition.operands[1]).interval.lo};
  }

  /// Of a list's elements, of which each has the condition that the index is its place, those count that are
  /// the constant. As the index has one value, it need not be said that it is none of the places before.
  std::optional<NodeId> of_list(NodeId id, NodeId index, unsigned depth) {
    NodeId any = kFalse, none = kTrue;
    std::optional<std::int64_t> last;
    std::int64_t places = 0;
    while (true) {
      const Graph::Node node = graph_.node(id);
      const auto place = place_of(node);
      if (!place || place->index != index || (last && place->number <= *last)) break;
      const auto element = of(node.operands[1], depth + 1);
      if (!element || ++visits_ >= kMostVisits) return std::nullopt;
      any = graph_.disjunction(any, graph_.conjunction(node.operands[0], *element));
      none = graph_.conjunction(none, graph_.negation(node.operands[0]));
      last = place->number;
      ++places;
      id = node.operands[2];
    }
    const auto rest = of(id, depth + 1);
    if (!rest) return std::nullopt;
    const Interval indices = graph_.node(index).interval;
    if (*last + 1 == indices.hi && places == indices.hi - indices.lo)
      none = graph_.apply(Op::kEqInt, {index, graph_.constant(indices.hi)});
    return graph_.disjunction(any, graph_.conjunction(none, *rest));
  }

  static constexpr unsigned kMostDepth = 40;  // more than a list has, whose choices are a balanced tree
  static constexpr std::size_t kMostVisits = 4'000'000;  // some hundredths of a second

  Graph& graph_;
  NodeId constant_;
  std::size_t visits_ = 0;
};

}  // namespace

std::optional<NodeId> Graph::simplify_equal(NodeId a, NodeId b) {
  if (a == b) return kTrue;
  if (disjoint(node(a).interval, node(b).interval)) return kFalse;
  if (node(a).op == Op::kConstInt) std::swap(a, b);
  if (node(b).op != Op::kConstInt) return std::nullopt;
  if (node(a).op == Op::kAdd || node(a).op == Op::kSub) return move_offset(Op::kEqInt, a, b);
  // abs(x) == 3 is x == 3 or x == -3.
  if (node(a).op == Op::kAbs) {
    const NodeId inner = node(a).operands[0];
    const NodeId opposite = constant(-node(b).interval.lo);
    return disjunction(apply(Op::kEqInt, {inner, b}), apply(Op::kEqInt, {inner, opposite}));
  }
  // if(c, 10, -5) == 10 is c.
  if (node(a).op == Op::kIteInt) return EqualToConstant(*this, b).of(a);
  if (node(a).op == Op::kChoice) {
    const Distribution& domain = variable(a).domain;
    if ((node(b).interval.lo - domain.lo) % domain.step != 0) return kFalse;
  }
  return std::nullopt;
}

}  // namespace solitaire
