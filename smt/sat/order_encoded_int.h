#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "smt/sat/circuit.h"

namespace solitaire {

/// An int in order encoding (Tamura, Taga, Kitagawa and Banbara 2009): each of its values but the lowest has
/// a literal that says that the int is no less. Comparisons need no arithmetic. They are a clause of two
/// literals for each value, through which bounds pass from one int to the other as in a finite domain solver.
struct OrderEncodedInt {
  std::vector<std::int64_t> values;  // ascending, at least one
  std::vector<Literal> reached;      // for each value but the first, that the int is no less; never constants
  mutable bool is_used = false;      // uses of all these literals have been counted

  std::size_t size() const { return values.size(); }
  /// Returns the literal that says that the int is no less than the bound.
  Literal at_least(std::int64_t bound) const;
  /// Returns the literal that says that the int is no less than the value at that position. At the position
  /// behind the last value that never holds.
  Literal reaches(std::size_t position) const;
  /// Returns the literal that says that the int is more than the bound.
  Literal more_than(std::int64_t bound) const { return at_least(bound + 1); }
};

/// Counts so many uses of each literal that all get variables of their own, as clauses with all of them need.
void use(Circuit& circuit, const OrderEncodedInt& order);

OrderEncodedInt constant_order(std::int64_t value);
OrderEncodedInt negated(const OrderEncodedInt& a);
/// Returns the int times a constant that is not 0.
OrderEncodedInt scaled(const OrderEncodedInt& a, std::int64_t factor);
/// Returns the floor of the int divided by a positive constant.
OrderEncodedInt divided(const OrderEncodedInt& a, std::int64_t divisor);
/// Returns the sum. This makes as many gates as the product of both sizes.
OrderEncodedInt sum(Circuit& circuit, const OrderEncodedInt& a, const OrderEncodedInt& b);
OrderEncodedInt select(Circuit& circuit, Literal condition, const OrderEncodedInt& a,
                       const OrderEncodedInt& b);
OrderEncodedInt smaller(Circuit& circuit, const OrderEncodedInt& a, const OrderEncodedInt& b);
OrderEncodedInt larger(Circuit& circuit, const OrderEncodedInt& a, const OrderEncodedInt& b);

using SharedOrder = std::shared_ptr<const OrderEncodedInt>;
/// Returns the literal of a <= b, or of a < b.
Literal less(Circuit& circuit, const SharedOrder& a, const SharedOrder& b, bool or_equal);
Literal equal(Circuit& circuit, const SharedOrder& a, const SharedOrder& b);

}  // namespace solitaire
