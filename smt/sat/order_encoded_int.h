#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "smt/sat/circuit.h"

namespace solitaire {

/// A number told by which of its possible values it reaches (order encoding; Tamura, Taga, Kitagawa and
/// Banbara 2009). Comparisons need no arithmetic: they are a clause of two literals for each value, through
/// which bounds travel from one number to the other as in a finite domain solver.
struct OrderEncodedInt {
  std::vector<std::int64_t> values;  // ascending, at least one
  std::vector<Literal> reached;      // of each value but the first: whether it is no less; never a constant

  std::size_t size() const { return values.size(); }
  /// Whether the number is no less than the bound.
  Literal at_least(std::int64_t bound) const;
  /// Whether it is no less than the value at that position, or than anything, behind the last one.
  Literal reaches(std::size_t position) const;
  /// Whether it is more than the bound.
  Literal more_than(std::int64_t bound) const { return at_least(bound + 1); }
};

OrderEncodedInt constant_order(std::int64_t value);
OrderEncodedInt negated(const OrderEncodedInt& a);
/// Times a constant that is not 0.
OrderEncodedInt scaled(const OrderEncodedInt& a, std::int64_t factor);
/// Floor division by a positive constant.
OrderEncodedInt divided(const OrderEncodedInt& a, std::int64_t divisor);
/// Makes as many gates as the product of their sizes has.
OrderEncodedInt sum(Circuit& circuit, const OrderEncodedInt& a, const OrderEncodedInt& b);
OrderEncodedInt select(Circuit& circuit, Literal condition, const OrderEncodedInt& a,
                       const OrderEncodedInt& b);
OrderEncodedInt smaller(Circuit& circuit, const OrderEncodedInt& a, const OrderEncodedInt& b);
OrderEncodedInt larger(Circuit& circuit, const OrderEncodedInt& a, const OrderEncodedInt& b);

using SharedOrder = std::shared_ptr<const OrderEncodedInt>;
/// a <= b, or a < b.
Literal less(Circuit& circuit, const SharedOrder& a, const SharedOrder& b, bool or_equal);
Literal equal(Circuit& circuit, const SharedOrder& a, const SharedOrder& b);

}  // namespace solitaire
