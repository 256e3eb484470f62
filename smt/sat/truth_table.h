#pragma once
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "smt/sat/circuit.h"
#include "smt/sat/order_encoded_int.h"
#include "tracegraph/graph.h"

namespace solitaire {

/// Says where a condition holds that depends on one choice or two, for all of their values. A part without a
/// value, as after a division by zero, counts as 0 there: other conditions rule such values out.
class TruthTable {
 public:
  TruthTable(const Graph& graph, NodeId condition, std::span<const NodeId> choices);
  /// Looks two ints up in a table of pairs.
  TruthTable(const PairTable& pairs, const OrderEncodedInt& first, const OrderEncodedInt& second);

  /// Returns whether the condition holds if the choices have their values with these numbers, from the lowest
  /// on. A second choice that it does not have is at 0.
  bool holds(std::size_t first, std::size_t second) const { return holds_[first * columns_ + second]; }

 private:
  std::size_t columns_ = 1;
  std::vector<bool> holds_;
};

/// Returns the literal of a condition on one choice.
Literal tabled(Circuit& circuit, const TruthTable& table, const OrderEncodedInt& choice);
/// Returns the literal of a condition on two choices. A clause for each value of one says which values of
/// the other fit (support clauses; Gent 2002), so that a value goes as soon as none that fits it is left.
Literal tabled(Circuit& circuit, TruthTable table, SharedOrder first, SharedOrder second);

}  // namespace solitaire
