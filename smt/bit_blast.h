#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "smt/bits.h"
#include "smt/cnf.h"
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

  /// The literal of a bool node. Throws std::logic_error for a node of floats. The bounds of choices that are
  /// met go to the Cnf.
  Literal condition(NodeId node);
  /// Adds literals of which one holds where the condition does. That a choice has another value than this one
  /// is said by its bits: clauses that keep thousands of solutions from coming again need no further
  /// variables.
  void add_alternatives(NodeId condition, std::vector<Literal>& literals);
  /// Makes the bits of a choice, whether or not a condition meets it; its bounds go to the Cnf.
  void add_choice(NodeId choice) { blast(choice); }
  /// The bits of a choice variable; none if no condition has met it.
  std::span<const Literal> choice_bits(std::size_t variable) const;
  /// The value of a choice, from the value of its bits read as an unsigned number.
  std::int64_t decode(std::size_t variable, std::uint64_t bits) const;
  /// The bits of a value: the other way round.
  std::uint64_t bits_of(std::size_t variable, std::int64_t value) const;

 private:
  friend struct BitBlasts;

  void blast(NodeId node);
  Bits blast_node(NodeId node);
  Bits blast_choice(NodeId node);
  Bits bounded_input(Interval interval);
  Bits with_known_bits(Bits bits, Interval interval) const;

  Literal literal(NodeId node) const { return nodes_[node.index][0]; }
  const Bits& bits(NodeId node) const { return nodes_[node.index]; }
  Interval interval(NodeId node) const { return graph_.node(node).interval; }
  bool is_signed(NodeId node) const { return interval(node).lo < 0; }
  bool either_signed(NodeId a, NodeId b) const { return is_signed(a) || is_signed(b); }
  std::size_t width(NodeId node) const { return nodes_[node.index].size(); }
  Bits sized(NodeId node, std::size_t width) const { return resized(bits(node), width, is_signed(node)); }
  std::size_t common_width(NodeId a, NodeId b) const;

  Literal equality(NodeId a, NodeId b);
  Literal comparison(NodeId a, NodeId b, bool or_equal);
  Bits extreme(NodeId a, NodeId b, bool smaller, std::size_t width);
  Bits product(NodeId a, NodeId b, std::size_t width);
  Bits quotient(NodeId a, NodeId b, std::size_t width);
  Bits modulus(NodeId a, NodeId b, std::size_t width);
  struct FloorDivision;
  FloorDivision floor_divide(NodeId a, NodeId b);

  const Graph& graph_;
  Circuit& circuit_;
  Cnf& cnf_;
  std::vector<Bits> nodes_;    // none: not compiled yet
  std::vector<Bits> choices_;  // by variable
};

}  // namespace solitaire
