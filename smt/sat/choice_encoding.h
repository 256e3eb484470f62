#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "smt/sat/bits.h"
#include "smt/sat/circuit.h"
#include "smt/sat/cnf.h"
#include "smt/sat/order_encoded_int.h"
#include "smt/sat/order_size.h"
#include "tracegraph/graph.h"

namespace solitaire {

/// Says by which inputs of a circuit each choice is represented, and translates between values and inputs.
///
/// A choice of few values has an input for each value but the lowest, which says that the choice is no less
/// (order encoding). Any other choice has an input for each of its bits: those of its value or, where its
/// step is not 1, of the number of steps from its lowest value.
class ChoiceEncoding {
 public:
  ChoiceEncoding(const Graph& graph, Circuit& circuit, Cnf& cnf)
      : graph_(graph), circuit_(circuit), cnf_(cnf) {}

  /// Has a choice variable written in bits, and without an order, however few values it has, unless it has
  /// its inputs already.
  void write_in_bits(std::size_t variable);
  /// Returns how many values the variable has in order encoding, if that is how it is or will be written.
  OrderSize order_size(std::size_t variable) const;
  /// Makes the inputs of a choice variable unless it has them. Their bounds go to the Cnf.
  void add(std::size_t variable);
  /// Returns one more than the number of the last variable that can have inputs.
  std::size_t size() const { return choices_.size(); }

  /// Returns the inputs of a variable, or none if it has not been added.
  std::span<const Literal> inputs(std::size_t variable) const;
  /// Returns the variable as an ordered int, or null if its inputs are bits. The variable has been added.
  const OrderEncodedInt* order(std::size_t variable) const;
  /// Returns the bits of a variable, which has been added. Those of an ordered one are made when they are
  /// first asked for.
  const Bits& bits(std::size_t variable);
  /// Returns the value of a choice node in binary, for which its variable is added.
  Bits number(NodeId choice);

  /// Returns whether an input of the variable holds where the variable has that value.
  bool input_at(std::size_t variable, std::size_t input, std::int64_t value) const;
  /// Returns the value of a variable from those of its inputs.
  std::int64_t decode(std::size_t variable, const std::function<bool(Literal)>& holds) const;
  /// Returns the value of a variable from its bits read as an unsigned number.
  std::int64_t decode(std::size_t variable, std::uint64_t bits) const;

 private:
  struct Choice {
    std::optional<OrderEncodedInt> order;
    Bits inputs;
    Bits bits;
    bool without_order = false;
  };

  const Distribution& domain(std::size_t variable) const { return graph_.variables()[variable].domain; }
  Interval numbers(std::size_t variable) const;
  std::uint64_t bits_of(std::size_t variable, std::int64_t value) const;
  OrderEncodedInt ordered_input(const Distribution& domain, Bits& inputs);
  Bits bounded_input(Interval interval);
  Bits bits_of_order(std::size_t variable, const OrderEncodedInt& order);

  const Graph& graph_;
  Circuit& circuit_;
  Cnf& cnf_;
  std::vector<Choice> choices_;  // by variable
};

/// Returns the bits with those replaced by constants that all values of the interval have in common.
Bits with_known_bits(Bits bits, Interval interval);

}  // namespace solitaire
