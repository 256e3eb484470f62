#pragma once
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "smt/sat/bits.h"
#include "smt/sat/choice_encoding.h"
#include "smt/sat/circuit.h"
#include "smt/sat/cnf.h"
#include "smt/sat/digits.h"
#include "smt/sat/int_bits.h"
#include "smt/sat/linear_form.h"
#include "smt/sat/order_encoded_int.h"
#include "smt/sat/order_sizes.h"
#include "smt/sat/small_cones.h"
#include "tracegraph/graph.h"

namespace solitaire {

/// Compiles nodes of a trace graph to a circuit. An int is written in binary (IntBits), in order encoding
/// (OrderEncodedInt), or both, depending on where it is needed: a comparison reads orders if both of its
/// operands can have one, or if it is one of sums of ints that can, which then are its terms; everything else
/// reads bits, but for conditions on one choice or two of few values, which are written as tables.
///
/// Every node is a total function of the choices' bits. So a node without a value, such as a division by zero
/// on a path that is not taken, rules nothing out.
class BitBlaster {
 public:
  BitBlaster(const Graph& graph, Circuit& circuit, Cnf& cnf)
      : graph_(graph),
        circuit_(circuit),
        cnf_(cnf),
        choices_(graph, circuit, cnf),
        order_sizes_(graph, choices_),
        small_cones_(graph) {}

  /// Returns the literal of a bool node. The bounds of choices that are met for the first time are added to
  /// the Cnf. Throws UnsupportedOperation.
  Literal condition(NodeId node);
  /// Requires a condition, and all parts of a conjunction one by one. That two ints in order encoding differ
  /// becomes an order difference without gates: where many ints have to differ, each two of them do. What is
  /// required is a constant for conditions that come later. Throws UnsupportedOperation.
  void require(NodeId condition);
  /// Appends literals to `literals`, one of which holds where the condition does. A condition that a choice
  /// differs from a value becomes the choice's own literals, so that clauses that keep thousands of solutions
  /// from coming again need no further variables. Throws UnsupportedOperation.
  void add_alternatives(NodeId condition, std::vector<Literal>& literals) {
    add_alternatives(condition, true, literals);
  }

  /// The inputs of the choices that conditions have met so far.
  ChoiceEncoding& choices() { return choices_; }
  const ChoiceEncoding& choices() const { return choices_; }

  /// Returns the literal of a <= b, or of a < b, without linear implications.
  Literal comparison_in_gates(NodeId a, NodeId b, bool or_equal);

 private:
  friend struct BitBlasts;

  /// The ways to write an int.
  enum class Form : std::uint8_t { kBits, kOrder };
  struct Part {
    NodeId node;
    Form form;  // of ints
  };
  /// What became of a node so far; 0 stands for nothing.
  struct Compiled {
    std::uint32_t bits =
        0;  // of a bool, 1 + the code of its literal; of an int, its place in numbers_ from 1
    std::uint32_t order = 0;  // its place in orders_ from 1
  };

  void meet_new_nodes();
  void compile(Part part);
  bool is_compiled(Part part) const;
  void push_operands(Part part, std::vector<Part>& pending);
  void compile_one(Part part);
  Form form_of_operands(Part part) const;
  const LinearForm* linear_form(NodeId a, NodeId b);
  void add_other_values(std::size_t variable, std::int64_t value, std::vector<Literal>& literals);
  OrderEncodedInt choice_order(NodeId choice);
  OrderEncodedInt sum_order(const OrderEncodedInt& a, const OrderEncodedInt& b);

  Literal table(NodeId condition, std::span<const NodeId> choices);
  Literal allowed(NodeId a, NodeId b, const PairTable& pairs);
  Literal has_value(NodeId node, std::size_t value);
  bool is_difference_of_orders(NodeId condition);
  void require_different(NodeId equation);
  void require_by_clause(NodeId condition);
  /// The same of a condition that holds, or that does not.
  void add_alternatives(NodeId condition, bool holds, std::vector<Literal>& literals);
  /// Returns true if nobody has asked for the condition yet, and no table says when it holds.
  bool is_open(NodeId condition);
  bool is_choice_of_value(NodeId condition) const;
  Literal equality(NodeId a, NodeId b);
  Literal all_equal(const std::vector<ShiftedEquality>& equalities);
  Literal comparison(NodeId a, NodeId b, bool or_equal);
  Literal linear_less(NodeId a, NodeId b, bool or_equal, const LinearForm& form);

  bool is_int(NodeId node) const { return graph_.node(node).type() == Type::kInt; }
  Interval interval(NodeId node) const { return graph_.node(node).interval; }
  void set_literal(NodeId node, Literal literal) { compiled_[node.index].bits = literal.code() + 1; }
  Literal literal(NodeId node) const {
    const std::uint32_t code = compiled_[node.index].bits - 1;
    return {code / 2, code % 2 != 0};
  }
  IntBits number(NodeId node) const { return {numbers_[compiled_[node.index].bits - 1], interval(node)}; }
  const SharedOrder& order(NodeId node) const { return orders_[compiled_[node.index].order - 1]; }

  const Graph& graph_;
  Circuit& circuit_;
  Cnf& cnf_;
  ChoiceEncoding choices_;
  OrderSizes order_sizes_;
  std::vector<Compiled> compiled_;  // by node
  std::deque<Bits> numbers_;
  std::deque<SharedOrder> orders_;
  SmallCones small_cones_;
  std::unordered_map<std::uint64_t, std::optional<LinearForm>> linear_forms_;  // by the nodes compared
  std::unordered_map<std::uint64_t, Literal> equal_ints_;  // by two nodes: that these digits are equal
};

}  // namespace solitaire
