#pragma once
#include <cstdint>

#include "tracegraph/interval.h"

namespace solitaire {

/// The number of values that an int has in order encoding, at most.
struct OrderSize {
  std::uint64_t most = 0;    // 0: the int is not written in order encoding
  std::uint64_t stride = 1;  // all differences of its values are multiples of this; 0: it has one value alone

  bool is_ordered() const { return most > 0; }
};

/// An operand, with its size in order encoding.
struct Sized {
  OrderSize size;
  Interval interval;
};

/// These functions return the size of an int with that interval, given the sizes of the operands. The result
/// is not written in order encoding if an operand is not, or if there are too many values.
OrderSize size_within(Interval interval, std::uint64_t most, std::uint64_t stride);
/// The size of a sum or a difference.
OrderSize sum_size(Interval interval, OrderSize a, OrderSize b);
/// The size of a larger one of which there are so many comparisons: clauses for each pair of values are worth
/// it if many share them.
OrderSize compared_sum_size(Interval interval, OrderSize a, OrderSize b, std::uint64_t comparisons);
/// The size of a product, of which one operand has to be constant.
OrderSize product_size(Interval interval, const Sized& a, const Sized& b);
/// The size of a quotient, whose divisor has to be a positive constant.
OrderSize quotient_size(Interval interval, const Sized& a, const Sized& b);
/// The size of what is always one of the operands.
OrderSize either_size(Interval interval, const Sized& a, const Sized& b);

}  // namespace solitaire
