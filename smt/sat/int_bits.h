#pragma once
#include <cstddef>

#include "smt/sat/bits.h"
#include "smt/sat/circuit.h"
#include "tracegraph/interval.h"

namespace solitaire {

/// An int in binary with the fewest bits that hold its interval. It is an unsigned number if the interval has
/// no negative value, and a two's complement number otherwise. The bits are kept elsewhere.
///
/// All results of a given width are taken modulo 2^width.
struct IntBits {
  const Bits& bits;
  Interval interval;

  std::size_t width() const { return bits.size(); }
  bool is_signed() const { return interval.lo < 0; }
  /// Returns the number extended or cut to a width.
  Bits sized(std::size_t wanted) const { return resized(bits, wanted, is_signed()); }
};

Literal equal(Circuit& circuit, const IntBits& a, const IntBits& b);
/// Returns the literal of a <= b or of a < b.
Literal less(Circuit& circuit, const IntBits& a, const IntBits& b, bool or_equal);
/// Returns the smaller or the larger one.
Bits extreme(Circuit& circuit, const IntBits& a, const IntBits& b, bool smaller, std::size_t width);
Bits product(Circuit& circuit, const IntBits& a, const IntBits& b, std::size_t width);
/// Floor division, and its remainder, which has the divisor's sign. Division by zero gives an arbitrary
/// number.
Bits quotient(Circuit& circuit, const IntBits& a, const IntBits& b, std::size_t width);
Bits modulus(Circuit& circuit, const IntBits& a, const IntBits& b, std::size_t width);

}  // namespace solitaire
