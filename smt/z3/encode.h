#pragma once
#include <optional>
#include <vector>
#include <z3++.h>

#include "tracegraph/address.h"
#include "tracegraph/graph.h"

namespace solitaire {

/// Compiles nodes of a trace graph to Z3 terms: bools to Bool, ints to bit-vectors. An int whose interval has
/// no negative value is an unsigned vector of the fewest bits that hold it, any other one a two's complement
/// vector; so no operation can wrap, and none is wider than it must be.
///
/// A fixed width, such as the dissertation's 16 bits (section 4.2.1), is that of every int, in two's
/// complement; then ints do wrap. What the intervals decided when the graph was made stays as it is.
class Encoder {
 public:
  /// `fixed_width`: 0 for the least widths, else 2 to 63 bits.
  Encoder(z3::context& context, const Graph& graph, const AddressTable& addresses, unsigned fixed_width = 0);

  /// Returns the term of a bool node. Throws UnsupportedOperation and ChoiceTooWide.
  z3::expr condition(NodeId node);
  /// Returns true if the vectors of all encoded ints hold all values that these can have.
  bool exact() const { return exact_; }
  /// Returns the bounds of the choices that have been encoded since the last call. They have to be required.
  std::vector<z3::expr> take_domains();
  /// Returns the term that stands for a choice variable, if it was encoded. See decode().
  std::optional<z3::expr> choice_term(std::size_t variable) const;
  /// Returns the value of a choice, given the value of its term read as an unsigned number.
  std::int64_t decode(std::size_t variable, std::uint64_t bits) const;

 private:
  friend struct Encodings;

  void encode(NodeId node);
  z3::expr encode_node(NodeId node);
  z3::expr encode_choice(NodeId node);
  void check_fits(const ChoiceVariable& variable, Interval values) const;
  const z3::expr& term(NodeId node) const { return *terms_[node.index]; }

  Interval interval(NodeId node) const { return graph_.node(node).interval; }
  bool is_signed(NodeId node) const { return fixed_width_ != 0 || interval(node).lo < 0; }
  unsigned width(NodeId node) const { return width(interval(node)); }
  unsigned width(Interval values) const {
    return fixed_width_ != 0 ? fixed_width_ : static_cast<unsigned>(bit_width(values));
  }
  bool fits(Interval values) const;
  /// Returns the node's vector, extended or cut to a width.
  z3::expr sized(NodeId node, unsigned width) const;
  /// Returns the least width at which both can be compared, with a sign bit if either can be negative.
  unsigned common_width(NodeId a, NodeId b) const;
  bool either_signed(NodeId a, NodeId b) const { return is_signed(a) || is_signed(b); }
  z3::expr less(NodeId a, NodeId b, bool or_equal) const;
  z3::expr floor_divide(NodeId a, NodeId b) const;
  z3::expr floor_modulo(NodeId a, NodeId b) const;
  z3::expr is(NodeId node, std::size_t value) const;
  z3::expr allowed(NodeId a, NodeId b, const PairTable& pairs) const;

  z3::context& context_;
  const Graph& graph_;
  const AddressTable& addresses_;
  unsigned fixed_width_;  // or 0
  bool exact_ = true;
  std::vector<std::optional<z3::expr>> terms_;
  std::vector<std::optional<z3::expr>> choices_;  // by variable
  std::vector<z3::expr> domains_;
};

}  // namespace solitaire
