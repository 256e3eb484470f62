#pragma once
#include <cstdint>
#include <vector>

#include "smt/sat/circuit.h"

namespace solitaire {

/// A binary number of literals, the least significant first. What two of them make has the width of the
/// first; unless it is said otherwise, both have the same and results are modulo 2^width.
using Bits = std::vector<Literal>;

Bits constant_bits(std::int64_t value, std::size_t width);
/// Extended or cut to a width.
Bits resized(Bits bits, std::size_t width, bool is_signed);
Bits inverted(Bits bits);

Bits add(Circuit& circuit, const Bits& a, const Bits& b, Literal carry = kFalseLiteral);
Bits subtract(Circuit& circuit, const Bits& a, const Bits& b);
/// The bits negated where the condition holds.
Bits negate_if(Circuit& circuit, Literal condition, const Bits& bits);
Bits exclusive_or(Circuit& circuit, const Bits& bits, Literal with);
Bits select(Circuit& circuit, Literal condition, const Bits& a, const Bits& b);
/// `b` may have any width.
Bits multiply(Circuit& circuit, const Bits& a, const Bits& b, bool b_signed);
Bits multiply(Circuit& circuit, const Bits& a, std::int64_t constant);

Literal equal(Circuit& circuit, const Bits& a, const Bits& b);
/// As unsigned numbers.
Literal less(Circuit& circuit, const Bits& a, const Bits& b, bool or_equal);

struct Division {
  Bits quotient;   // of the dividend's width
  Bits remainder;  // of the divisor's width
};
/// As unsigned numbers of any widths. Division by zero gives some numbers.
Division divide(Circuit& circuit, const Bits& a, const Bits& b);

}  // namespace solitaire
