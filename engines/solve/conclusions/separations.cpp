#include "engines/solve/conclusions/separations.h"

#include "tracegraph/seen_parts.h"

namespace solitaire {
namespace {

/// from + least <= to.
struct Precedence {
  NodeId from, to;
  std::int64_t least = 0;
};

/// A node as another one and an offset. A constant is an offset from nothing.
struct Shifted {
  std::optional<NodeId> base;
  std::int64_t offset = 0;
};

/// Reads conditions: takes them apart, and says what comparisons mean.
class ConditionReader {
 public:
  explicit ConditionReader(const Graph& graph) : graph_(graph) {}

  /// Calls `visit` with each literal of a conjunction, or of a disjunction, until it returns false. What
  /// is_new(part) denies is left out, with what is in it.
  template <class IsNew, class Visit>
  void for_each_part(Op connective, SignedNode whole, IsNew is_new, Visit visit) const {
    std::vector<SignedNode> pending{whole};
    while (!pending.empty()) {
      const SignedNode at = pending.back();
      pending.pop_back();
      if (!is_new(at)) continue;
      const Graph::Node& node = graph_.node(at.node);
      const Op splits = at.holds == (connective == Op::kAnd) ? Op::kAnd : Op::kOr;
      if (node.op == Op::kNot) {
        pending.push_back({node.operands[0], !at.holds});
      } else if (node.op == splits) {
        for (const NodeId operand : node.args()) pending.push_back({operand, at.holds});
      } else if (!visit(at)) {
        return;
      }
    }
  }

  /// Returns the comparison of ints that the literal is.
  std::optional<Precedence> before(SignedNode literal) const {
    const Graph::Node& node = graph_.node(literal.node);
    if (node.op != Op::kLeInt && node.op != Op::kLtInt) return std::nullopt;
    const bool strict = (node.op == Op::kLtInt) == literal.holds;
    const auto [a, b] = std::array{node.operands[0], node.operands[1]};
    return literal.holds ? Precedence{a, b, strict ? 1 : 0} : Precedence{b, a, strict ? 1 : 0};
  }

  /// Returns a lower bound of a - b, if the nodes show one.
  std::optional<std::int64_t> least_difference(NodeId a, NodeId b) const {
    const Shifted x = shifted(a), y = shifted(b);
    if (x.base == y.base) return x.offset - y.offset;
    if (!x.base || graph_.node(*x.base).op != Op::kAdd) return std::nullopt;
    const auto& terms = graph_.node(*x.base).operands;
    for (std::size_t i = 0; i < 2; ++i) {
      const Shifted term = shifted(terms[i]);
      if (term.base == y.base)
        return graph_.node(terms[1 - i]).interval.lo + term.offset + x.offset - y.offset;
    }
    return std::nullopt;
  }

 private:
  Shifted shifted(NodeId id) const {
    const Graph::Node& node = graph_.node(id);
    if (node.is_constant()) return {std::nullopt, node.interval.lo};
    if (node.op == Op::kAdd && graph_.node(node.operands[1]).is_constant())
      return {node.operands[0], graph_.node(node.operands[1]).interval.lo};
    return {id, 0};
  }

  const Graph& graph_;
};

/// Takes note of bounds that comparisons give.
class BoundsReader {
 public:
  explicit BoundsReader(const Graph& graph, std::unordered_map<NodeId, IntBounds>& table)
      : graph_(graph), table_(table) {}

  void add(const Precedence& before, SignedNode literal) {
    const Interval from = graph_.node(before.from).interval, to = graph_.node(before.to).interval;
    IntBounds& upper = bounds(before.to);
    if (from.lo + before.least > upper.values.lo) {
      upper.values.lo = from.lo + before.least;
      upper.low = literal;
    }
    // From a + w <= b, a bound of a follows as well.
    limit(before.from, to.hi - before.least, literal);
    const Graph::Node& node = graph_.node(before.from);
    if (node.op != Op::kAdd) return;
    for (std::size_t i = 0; i < 2; ++i) {
      if (graph_.node(node.operands[i]).is_constant()) continue;
      const Interval other = graph_.node(node.operands[1 - i]).interval;
      limit(node.operands[i], to.hi - before.least - other.lo, literal);
    }
  }

 private:
  IntBounds& bounds(NodeId node) {
    return table_.try_emplace(node, IntBounds{graph_.node(node).interval, {}, {}}).first->second;
  }

  void limit(NodeId node, std::int64_t high, SignedNode literal) {
    IntBounds& bounded = bounds(node);
    if (high >= bounded.values.hi) return;
    bounded.values.hi = high;
    bounded.high = literal;
  }

  const Graph& graph_;
  std::unordered_map<NodeId, IntBounds>& table_;
};

/// Returns the comparisons of which a condition is the disjunction, or nothing if it is none or has too many.
std::vector<Precedence> alternatives(const ConditionReader& reader, SignedNode condition) {
  std::vector<Precedence> parts;
  const auto each = [](SignedNode) { return true; };
  reader.for_each_part(Op::kOr, condition, each, [&](SignedNode part) {
    const auto before = parts.size() < 4 ? reader.before(part) : std::nullopt;
    if (before) {
      parts.push_back(*before);
    } else {
      parts.clear();
    }
    return before.has_value();
  });
  return parts;
}

/// Takes a comparison from the list, and the one by which the same two things would stand the other way
/// round.
std::optional<AxisSeparation> take_axis(const ConditionReader& reader, std::vector<Precedence>& parts) {
  const Precedence first = parts.back();
  parts.pop_back();
  for (auto second = parts.begin(); second != parts.end(); ++second) {
    const auto a = reader.least_difference(first.from, second->to);
    const auto b = reader.least_difference(second->from, first.to);
    if (!a || !b || *a + first.least < 1 || *b + second->least < 1) continue;
    const AxisSeparation axis{{second->to, first.to}, {*a + first.least, *b + second->least}};
    parts.erase(second);
    return axis;
  }
  return std::nullopt;
}

/// Returns which things a condition keeps apart, if it is of that kind.
std::optional<Separation> separation_of(const Graph& graph, const ConditionReader& reader,
                                        SignedNode condition) {
  const Graph::Node& node = graph.node(condition.node);
  if (!condition.holds && node.op == Op::kEqInt)
    return Separation{condition, {AxisSeparation{{node.operands[0], node.operands[1]}, {1, 1}}}, 1};
  std::vector<Precedence> parts = alternatives(reader, condition);
  if (parts.size() != 2 && parts.size() != 4) return std::nullopt;
  Separation pair{condition, {}, 0};
  while (!parts.empty()) {
    const auto axis = take_axis(reader, parts);
    if (!axis) return std::nullopt;
    pair.axes[pair.number++] = *axis;
  }
  return pair;
}

}  // namespace

Separations find_separations(const Graph& graph, const std::vector<NodeId>& conditions) {
  Separations found;
  add_separations(graph, conditions, found);
  return found;
}

void add_separations(const Graph& graph, const std::vector<NodeId>& conditions, Separations& found) {
  const ConditionReader reader(graph);
  BoundsReader bounds(graph, found.bounds);
  SeenParts seen;
  seen.cover(graph);
  const auto is_new = [&](SignedNode part) { return seen.meet(part.node, part.holds); };
  for (const NodeId condition : conditions) {
    reader.for_each_part(Op::kAnd, {condition}, is_new, [&](SignedNode part) {
      if (const auto before = reader.before(part)) {
        bounds.add(*before, part);
        found.comparisons.push_back(part);
      } else if (part.holds && graph.node(part.node).op == Op::kEqInt) {
        found.comparisons.push_back(part);
      } else if (auto pair = separation_of(graph, reader, part)) {
        found.pairs.push_back(*pair);
      }
      return true;
    });
  }
}

}  // namespace solitaire
