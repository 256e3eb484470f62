#pragma once
#include <array>
#include <bit>
#include <initializer_list>
#include <memory>
#include <span>
#include <stdexcept>
#include <unordered_map>
#include <vector>

#include "base/unique_table.h"
#include "tracegraph/address.h"
#include "tracegraph/distribution.h"
#include "tracegraph/op.h"
#include "tracegraph/pair_table.h"

namespace solitaire {

/// A node of a Graph. Equal ids are equal expressions.
struct NodeId {
  std::uint32_t index = 0;
  friend bool operator==(NodeId, NodeId) = default;
};
inline constexpr NodeId kFalse{0};
inline constexpr NodeId kTrue{1};

/// A choice left open: the unknown that a solver gives a value.
struct ChoiceVariable {
  AddressId address;
  Distribution domain;
  friend bool operator==(const ChoiceVariable&, const ChoiceVariable&) = default;
};

/// Thrown where an int expression can leave the exact range; `bounds` is what it could become.
struct IntegerTooLarge : std::runtime_error {
  explicit IntegerTooLarge(Interval possible);
  Interval bounds;
};

/// Thrown where an operation on constants has no value, such as a division by zero.
struct UndefinedOperation : std::runtime_error {
  explicit UndefinedOperation(Op undefined);
  Op op;
};

/// The hash-consed DAG of operations on choices: every expression exists once, so a later pass that meets
/// the same expression finds the same node. Constants fold and simple identities apply when a node is made.
/// Every int node carries the interval of values it can take, from which comparisons are decided and bit
/// widths chosen. So does every bool node, as 0 and 1.
class Graph {
 public:
  struct Node {
    Op op;
    bool has_float;  // itself or an operand below it is a float: no bit-vector says it
    std::array<NodeId, 3> operands{};
    Interval interval;          // its lower end is the value of a constant bool or int
    std::uint64_t payload = 0;  // the bits of a float constant, or the number of a table or a choice

    std::span<const NodeId> args() const { return {operands.data(), operation(op).arity}; }
    Type type() const { return operation(op).result; }
    bool is_constant() const { return op <= Op::kConstTable; }
  };

  Graph();

  NodeId constant(bool value) { return value ? kTrue : kFalse; }
  NodeId constant(std::int64_t value);
  NodeId constant(double value);
  NodeId constant(Type type, Scalar value);
  /// The table of an operation on pairs (has_table). Equal tables are one node.
  NodeId table(const PairTable& pairs);
  /// The choice as a node: an int for an int or, as 0 or 1, a bool; a float for a float. A choice with one
  /// value alone is a constant.
  NodeId choice(const ChoiceVariable& variable);

  /// The operation applied to nodes of its operand types.
  /// Throws IntegerTooLarge if an int result can leave the exact range, UndefinedOperation if all operands
  /// are constants for which the operation means nothing.
  NodeId apply(Op op, std::initializer_list<NodeId> operands);

  /// A comparison of ints that stays one where the intervals of its operands say that it never holds, so that
  /// one can ask how far it is from holding. Its own interval then says so.
  NodeId open_comparison(Op op, NodeId a, NodeId b);

  NodeId negation(NodeId a) { return apply(Op::kNot, {a}); }
  NodeId conjunction(NodeId a, NodeId b) { return apply(Op::kAnd, {a, b}); }
  NodeId disjunction(NodeId a, NodeId b) { return apply(Op::kOr, {a, b}); }
  NodeId implication(NodeId a, NodeId b) { return disjunction(negation(a), b); }
  NodeId phi(NodeId condition, NodeId a, NodeId b) {
    return apply(ite_of(node(a).type()), {condition, a, b});
  }

  const Node& node(NodeId id) const { return nodes_[id.index]; }
  std::size_t size() const { return nodes_.size(); }

  const ChoiceVariable& variable(NodeId choice) const { return variables_[node(choice).payload]; }
  const std::vector<ChoiceVariable>& variables() const { return variables_; }
  /// The choice node of the variable with that number.
  NodeId variable_node(std::size_t number) const { return variable_nodes_[number]; }

  /// The value of a constant node.
  Scalar scalar(NodeId id) const;

 private:
  NodeId intern(const Node& node);
  NodeId fold(Op op, std::span<const NodeId> operands);
  std::optional<NodeId> simplify(Op op, std::span<const NodeId> operands);
  std::optional<NodeId> simplify_add(NodeId a, NodeId b);
  std::optional<NodeId> move_offset(Op op, NodeId a, NodeId b);
  std::optional<NodeId> simplify_and(NodeId a, NodeId b);
  std::optional<NodeId> simplify_or(NodeId a, NodeId b);
  std::optional<NodeId> simplify_ite(Op op, NodeId condition, NodeId a, NodeId b);
  std::optional<NodeId> simplify_equal(NodeId a, NodeId b);
  void order(NodeId& a, NodeId& b) const;
  bool opposite(NodeId a, NodeId b) const;
  bool is_int(NodeId id, std::int64_t value) const;
  static std::uint64_t hash(const Node& node);

  std::vector<Node> nodes_;
  UniqueTable table_;  // finds equal nodes
  std::vector<std::shared_ptr<const PairTable>> pair_tables_;
  std::vector<ChoiceVariable> variables_;
  std::vector<NodeId> variable_nodes_;
  struct VariableHash {
    std::size_t operator()(const ChoiceVariable& variable) const;
  };
  std::unordered_map<ChoiceVariable, std::uint32_t, VariableHash> variable_ids_;
};

}  // namespace solitaire

template <>
struct std::hash<solitaire::NodeId> {
  std::size_t operator()(solitaire::NodeId id) const noexcept { return id.index; }
};
