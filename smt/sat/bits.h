#pragma once
#include <cstdint>
#include <vector>

#include "smt/sat/circuit.h"

namespace solitaire {

/// A binary number whose digits are literals, the least significant first. Unless it is said otherwise, both
/// operands of a function have the same width, and so has the result, which is taken modulo 2^width. Where
/// widths differ, the result has that of the first operand.
using Bits = std::vector<Literal>;

Bits constant_bits(std::int64_t value, std::size_t width);
/// Returns the number extended or cut to a width.
Bits resized(Bits bits, std::size_t width, bool is_signed);
Bits inverted(Bits bits);

Bits add(Circuit& circuit, const Bits& a, const Bits& b, Literal carry = kFalseLiteral);
Bits subtract(Circuit& circuit, const Bits& a, const Bits& b);
/// Returns the negative of a number where the condition holds, and the number itself elsewhere.
Bits negate_if(Circuit& circuit, Literal condition, const Bits& bits);
Bits exclusive_or(Circuit& circuit, const Bits& bits, Literal with);
Bits select(Circuit& circuit, Literal condition, const Bits& a, const Bits& b);
/// Returns the product. `b` may have any width.
Bits multiply(Circuit& circuit, const Bits& a, const Bits& b, bool b_signed);
Bits multiply(Circuit& circuit, const Bits& a, std::int64_t constant);

Literal equal(Circuit& circuit, const Bits& a, const Bits& b);
/// Returns the literal of a < b, or of a <= b, for unsigned numbers.
Literal less(Circuit& circuit, const Bits& a, const Bits& b, bool or_equal);

struct Division {
  Bits quotient;   // has the dividend's width
  Bits remainder;  // has the divisor's width
};
/// Divides unsigned numbers of any widths. Division by zero gives arbitrary numbers.
Division divide(Circuit& circuit, const Bits& a, const Bits& b);

}  // namespace solitaire
