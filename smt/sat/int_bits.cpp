#include "smt/sat/int_bits.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <optional>
#include <utility>

namespace solitaire {
namespace {

bool either_signed(const IntBits& a, const IntBits& b) { return a.is_signed() || b.is_signed(); }

/// Returns the least width at which both can be compared, with a sign bit if either can be negative.
std::size_t common_width(const IntBits& a, const IntBits& b) {
  if (!either_signed(a, b)) return std::max(a.width(), b.width());
  return std::max(a.width() + (a.is_signed() ? 0 : 1), b.width() + (b.is_signed() ? 0 : 1));
}

/// Returns the exponent if the int is always that power of two.
std::optional<std::size_t> exponent(const IntBits& a) {
  const auto value = static_cast<std::uint64_t>(a.interval.lo);
  if (!a.interval.single() || a.interval.lo <= 0 || !std::has_single_bit(value)) return std::nullopt;
  return static_cast<std::size_t>(std::countr_zero(value));
}

/// A division of numbers that are not negative, from which the floor division of a and b follows. For a
/// negative a, floor(a / b) is ~floor(~a / b), as ~a is -a - 1. If the divisor is negative, both numbers are
/// negated first.
struct FloorDivision {
  Literal dividend_sign, divisor_sign;
  Bits divisor;  // its absolute value
  Division division;
};

FloorDivision floor_divide(Circuit& circuit, const IntBits& a, const IntBits& b) {
  FloorDivision made;
  made.divisor_sign = b.is_signed() ? b.bits.back() : kFalseLiteral;
  made.divisor = negate_if(circuit, made.divisor_sign, b.bits);
  const std::size_t room = a.width() + (a.is_signed() ? 0 : 1) + (b.is_signed() ? 1 : 0);
  Bits dividend = a.sized(room);
  if (b.is_signed()) dividend = negate_if(circuit, made.divisor_sign, dividend);
  made.dividend_sign = dividend.back();
  dividend.pop_back();
  made.division = divide(circuit, exclusive_or(circuit, dividend, made.dividend_sign), made.divisor);
  return made;
}

}  // namespace

Literal equal(Circuit& circuit, const IntBits& a, const IntBits& b) {
  const std::size_t bits = common_width(a, b);
  return equal(circuit, a.sized(bits), b.sized(bits));
}

Literal less(Circuit& circuit, const IntBits& a, const IntBits& b, bool or_equal) {
  const std::size_t bits = common_width(a, b);
  Bits x = a.sized(bits);
  Bits y = b.sized(bits);
  if (either_signed(a, b)) {  // with inverted sign bits, signed numbers compare like unsigned ones
    x.back() = !x.back();
    y.back() = !y.back();
  }
  return less(circuit, x, y, or_equal);
}

Bits extreme(Circuit& circuit, const IntBits& a, const IntBits& b, bool smaller, std::size_t width) {
  const Literal first = less(circuit, a, b, true) ^ !smaller;
  return select(circuit, first, a.sized(width), b.sized(width));
}

Bits product(Circuit& circuit, const IntBits& a, const IntBits& b, std::size_t width) {
  if (b.interval.single()) return multiply(circuit, a.sized(width), b.interval.lo);
  if (a.interval.single()) return multiply(circuit, b.sized(width), a.interval.lo);
  const bool swap = a.width() < b.width();  // each bit of the second one makes a row of the sum
  const IntBits& rows = swap ? a : b;
  return multiply(circuit, (swap ? b : a).sized(width), rows.bits, rows.is_signed());
}

Bits quotient(Circuit& circuit, const IntBits& a, const IntBits& b, std::size_t width) {
  if (const auto shift = exponent(b)) {
    Bits bits = a.sized(*shift + std::max(width, a.width()));
    bits.erase(bits.begin(), bits.begin() + static_cast<std::ptrdiff_t>(*shift));
    return resized(std::move(bits), width, a.is_signed());
  }
  const FloorDivision made = floor_divide(circuit, a, b);
  Bits bits = exclusive_or(circuit, made.division.quotient, made.dividend_sign);
  bits.push_back(made.dividend_sign);
  return resized(std::move(bits), width, true);
}

/// The remainder has the divisor's sign. For a negative dividend it is divisor - 1 - r, where r is the
/// remainder of the division of positive numbers.
Bits modulus(Circuit& circuit, const IntBits& a, const IntBits& b, std::size_t width) {
  if (const auto kept = exponent(b))
    return resized(resized(a.sized(std::max(*kept, a.width())), *kept, false), width, false);
  const FloorDivision made = floor_divide(circuit, a, b);
  Bits base = made.divisor;
  for (Literal& bit : base) bit = circuit.conjunction(bit, made.dividend_sign);
  Bits bits = add(circuit, base, exclusive_or(circuit, made.division.remainder, made.dividend_sign));
  return negate_if(circuit, made.divisor_sign, resized(std::move(bits), width, false));
}

}  // namespace solitaire
