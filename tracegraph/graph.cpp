#include "tracegraph/graph.h"

#include <fmt/format.h>

#include "base/hash.h"

namespace solitaire {

IntegerTooLarge::IntegerTooLarge(Interval possible)
    : std::runtime_error("an int can grow past 62 bits"), bounds(possible) {}

UndefinedOperation::UndefinedOperation(Op undefined)
    : std::runtime_error(fmt::format("'{}' has no value here", operation(undefined).name)), op(undefined) {}

Graph::Graph() {
  intern({Op::kConstBool, false, {}, {0, 0}, 0});
  intern({Op::kConstBool, false, {}, {1, 1}, 0});
}

std::size_t Graph::VariableHash::operator()(const ChoiceVariable& variable) const {
  const Distribution& domain = variable.domain;
  std::uint64_t hash = mix(variable.address.index, static_cast<std::uint64_t>(domain.family));
  for (const std::int64_t each : {domain.lo, domain.hi, domain.step})
    hash = mix(hash, static_cast<std::uint64_t>(each));
  for (const double each : {domain.a, domain.b}) hash = mix(hash, std::hash<double>{}(each));
  for (std::size_t i = 0; i < domain.weights.size(); ++i)
    hash = mix(hash, std::hash<double>{}(domain.weights[i]));
  return hash;
}

inline std::uint64_t Graph::hash(const Node& node) {
  const auto [a, b, c] = node.operands;  // those that it has not are 0
  std::uint64_t hash = mix(std::uint64_t{a.index} << 32 | b.index,
                           std::uint64_t{c.index} << 32 | static_cast<std::uint64_t>(node.op));
  if (!node.is_constant() && !is_choice(node.op)) return hash;
  hash = mix(hash, node.payload);
  return mix(hash, static_cast<std::uint64_t>(node.interval.lo));
}

NodeId Graph::intern(const Node& node) {
  const auto equals = [&](std::uint32_t number) {
    const Node& other = nodes_[number];
    const bool same_constant = !node.is_constant() || other.interval == node.interval;
    return other.op == node.op && other.operands == node.operands && other.payload == node.payload &&
           same_constant;
  };
  const auto add = [&] {
    nodes_.push_back(node);
    return static_cast<std::uint32_t>(nodes_.size() - 1);
  };
  return {table_.find_or_add(hash(node), equals, add)};
}

NodeId Graph::constant(std::int64_t value) { return intern({Op::kConstInt, false, {}, {value, value}, 0}); }

NodeId Graph::constant(double value) {
  return intern({Op::kConstFloat, true, {}, {}, std::bit_cast<std::uint64_t>(value)});
}

NodeId Graph::constant(Type type, Scalar value) {
  switch (type) {
    case Type::kBool:
      return constant(value.i != 0);
    case Type::kInt:
      return constant(value.i);
    case Type::kFloat:
      return constant(value.f);
  }
  return kFalse;
}

/// There are few tables, and of these the newest are asked for mostly.
NodeId Graph::table(const PairTable& pairs) {
  std::size_t number = pair_tables_.size();
  while (number > 0 && *pair_tables_[number - 1] != pairs) --number;
  if (number == 0) {
    pair_tables_.push_back(std::make_shared<const PairTable>(pairs));
    number = pair_tables_.size();
  }
  return intern({Op::kConstTable, false, {}, {0, 0}, number - 1});
}

Scalar Graph::scalar(NodeId id) const {
  const Node& constant = node(id);
  if (constant.op == Op::kConstTable) return {.table = pair_tables_[constant.payload].get()};
  if (constant.op == Op::kConstFloat) return Scalar::of(std::bit_cast<double>(constant.payload));
  return Scalar::of(constant.interval.lo);
}

NodeId Graph::choice(const ChoiceVariable& variable) {
  const Distribution& domain = variable.domain;
  if (domain.is_finite() && domain.size() == 1) return constant(domain.lo);
  const auto [it, added] = variable_ids_.try_emplace(variable, static_cast<std::uint32_t>(variables_.size()));
  if (added) {
    variables_.push_back(variable);
    variable_nodes_.push_back(domain.type() != Type::kFloat
                                  ? intern({Op::kChoice, false, {}, domain.interval(), it->second})
                                  : intern({Op::kChoiceFloat, true, {}, {}, it->second}));
  }
  return variable_nodes_[it->second];
}

NodeId Graph::fold(Op op, std::span<const NodeId> operands) {
  std::array<Scalar, 3> values{};
  for (std::size_t i = 0; i < operands.size(); ++i) values[i] = scalar(operands[i]);
  const Operation& row = operation(op);
  const std::optional<Scalar> result = row.fold(values.data());
  if (!result) throw UndefinedOperation(op);
  return constant(row.result, *result);
}

/// One order for what can stand in either, so that equals meet: constants last, else the older node first.
void Graph::order(NodeId& a, NodeId& b) const {
  const auto rank = [this](NodeId id) { return std::pair(node(id).is_constant(), id.index); };
  if (rank(b) < rank(a)) std::swap(a, b);
}

/// Returns what the intervals of bools say of an operation on them.
static Interval truth(Op op, const Interval* operands) {
  switch (op) {
    case Op::kNot:
      return {1 - operands[0].hi, 1 - operands[0].lo};
    case Op::kAnd:
      return minimum(operands[0], operands[1]);
    case Op::kOr:
      return maximum(operands[0], operands[1]);
    default:
      return {0, 1};
  }
}

NodeId Graph::open_comparison(Op op, NodeId a, NodeId b) {
  const NodeId made = apply(op, {a, b});
  const bool can_differ = !node(a).is_constant() || !node(b).is_constant();
  if (made != kFalse || a == b || !can_differ) return made;
  if (operation(op).commutative) order(a, b);
  return intern({op, false, {a, b}, {0, 0}, 0});
}

NodeId Graph::apply(Op op, std::initializer_list<NodeId> operands) {
  Node made{op, operation(op).result == Type::kFloat, {}, {0, 1}, 0};
  std::array<Interval, 3> intervals;
  bool constant = true;
  std::size_t count = 0;
  for (const NodeId operand : operands) {
    const Node& below = node(operand);
    constant = constant && below.is_constant();
    made.has_float = made.has_float || below.has_float;
    intervals[count] = below.interval;
    made.operands[count++] = operand;
  }
  const Operation& row = operation(op);
  if (row.bounds != nullptr) {
    made.interval = row.bounds(intervals.data());
    if (!made.interval.exact()) throw IntegerTooLarge(made.interval);
  } else if (row.result == Type::kBool) {
    made.interval = truth(op, intervals.data());
  }
  if (constant) return fold(op, made.args());
  if (row.result == Type::kInt && made.interval.single() && op != Op::kDiv && op != Op::kMod) {
    return this->constant(made.interval.lo);
  }
  if (const auto simple = simplify(op, made.args())) return *simple;
  if (row.commutative) order(made.operands[0], made.operands[1]);
  return intern(made);
}

}  // namespace solitaire
