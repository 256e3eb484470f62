#pragma once
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "smt/sat/bits.h"
#include "smt/sat/cnf.h"
#include "smt/sat/order_encoded_int.h"
#include "tracegraph/graph.h"

namespace solitaire {

/// Compiles nodes of a trace graph to a circuit, by the conventions of encode.h: an int whose interval has no
/// negative value is an unsigned number of the fewest bits that hold it, any other one a two's complement
/// number.
///
/// Every node is a total function of the choices' bits. So one without a value, such as a division by zero on
/// a path that is not taken, rules nothing out.
class BitBlaster {
 public:
  BitBlaster(const Graph& graph, Circuit& circuit, Cnf& cnf) : graph_(graph), circuit_(circuit), cnf_(cnf) {}

  /// The literal of a bool node. Throws UnsupportedOperation. The bounds of choices that are
  /// met go to the Cnf.
  Literal condition(NodeId node);
  /// Adds literals of which one holds where the condition does. That a choice has another value than this one
  /// is said by its own literals: clauses that keep thousands of solutions from coming again need no further
  /// variables.
  void add_alternatives(NodeId condition, std::vector<Literal>& literals);

  /// One more than the number of the last choice variable that a condition has met.
  std::size_t choices() const { return choices_.size(); }
  /// The inputs that stand for a choice variable; none if no condition has met it.
  std::span<const Literal> choice_inputs(std::size_t variable) const;
  /// The same, of one that is met now if none was before.
  std::span<const Literal> add_choice(std::size_t variable) { return choice(variable).inputs; }
  /// Whether the inputs say which of its values the choice reaches, ascending; else they are bits.
  bool is_ordered(std::size_t variable) const { return choices_[variable].order.has_value(); }
  /// Whether an input of the choice holds where it has the value.
  bool input_at(std::size_t variable, std::size_t input, std::int64_t value) const;
  /// The value of a choice from those of its inputs.
  std::int64_t decode(std::size_t variable, const std::function<bool(Literal)>& holds) const;
  /// The value of a choice from its bits read as an unsigned number.
  std::int64_t decode(std::size_t variable, std::uint64_t bits) const;
  /// The bits of a choice variable: those of its value or, where its step is not 1, of the number of steps
  /// from its lowest. None if no condition has met it.
  Bits choice_bits(std::size_t variable);

 private:
  friend struct BitBlasts;

  /// How an int can be written.
  enum class Form : std::uint8_t { kBits, kOrder };
  struct Part {
    NodeId node;
    Form form;  // of ints
  };
  /// What became of a node. 0: nothing yet.
  struct Compiled {
    std::uint32_t bits = 0;   // of a bool, 1 + the code of its literal; of an int, where in numbers_,
    std::uint32_t order = 0;  // and where in orders_, both from 1 on
  };
  /// What a choice stands for: literals for its values where these are few, else bits.
  struct Choice {
    std::optional<OrderEncodedInt> order;
    Bits inputs;  // of the bits, or of the order
    Bits bits;    // of the value or the number of steps, once they are needed
  };

  struct OrderSize {
    std::uint64_t most = 0;    // of values; 0: not written so
    std::uint64_t stride = 1;  // differences of values are multiples of it; 0: one value alone
  };

  void compile(Part part);
  bool is_compiled(Part part) const;
  void push_operands(Part part, std::vector<Part>& pending);
  void compile_one(Part part);
  Form form_of_operands(Part part) const;
  OrderSize order_size(NodeId node) const;
  bool comparable_in_order(NodeId a, NodeId b) const;

  Choice& choice(std::size_t variable);
  OrderEncodedInt ordered_input(const Distribution& domain, Bits& inputs);
  Bits bits_of_order(std::size_t variable, const OrderEncodedInt& order);
  Bits choice_number(NodeId node);
  Bits bounded_input(Interval interval);
  Bits with_known_bits(Bits bits, Interval interval) const;
  std::uint64_t bits_of(std::size_t variable, std::int64_t value) const;

  Literal literal(NodeId node) const {
    const std::uint32_t code = compiled_[node.index].bits - 1;
    return {code / 2, code % 2 != 0};
  }
  const Bits& bits(NodeId node) const { return numbers_[compiled_[node.index].bits - 1]; }
  Interval interval(NodeId node) const { return graph_.node(node).interval; }
  bool is_signed(NodeId node) const { return interval(node).lo < 0; }
  bool either_signed(NodeId a, NodeId b) const { return is_signed(a) || is_signed(b); }
  std::size_t width(NodeId node) const { return bits(node).size(); }
  Bits sized(NodeId node, std::size_t width) const { return resized(bits(node), width, is_signed(node)); }
  std::size_t common_width(NodeId a, NodeId b) const;

  const OrderEncodedInt& order(NodeId node) const { return *shared_order(node); }
  const SharedOrder& shared_order(NodeId node) const { return orders_[compiled_[node.index].order - 1]; }

  Literal equality(NodeId a, NodeId b);
  Literal comparison(NodeId a, NodeId b, bool or_equal);
  Literal bit_comparison(NodeId a, NodeId b, bool or_equal);
  Bits extreme(NodeId a, NodeId b, bool smaller, std::size_t width);
  Bits product(NodeId a, NodeId b, std::size_t width);
  Bits quotient(NodeId a, NodeId b, std::size_t width);
  Bits modulus(NodeId a, NodeId b, std::size_t width);
  struct FloorDivision;
  FloorDivision floor_divide(NodeId a, NodeId b);

  const Graph& graph_;
  Circuit& circuit_;
  Cnf& cnf_;
  std::vector<Compiled> compiled_;  // by node
  std::deque<Bits> numbers_;
  std::deque<SharedOrder> orders_;
  std::vector<OrderSize> order_sizes_;  // of the nodes met
  std::vector<Choice> choices_;         // by variable
};

}  // namespace solitaire
