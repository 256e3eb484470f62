#include "smt/sat/bits.h"

#include <algorithm>

namespace solitaire {

Bits constant_bits(std::int64_t value, std::size_t width) {
  Bits bits(width);
  for (std::size_t i = 0; i < width; ++i) {
    bits[i] = constant_literal(((value >> std::min<std::size_t>(i, 63)) & 1) != 0);
  }
  return bits;
}

Bits resized(Bits bits, std::size_t width, bool is_signed) {
  bits.resize(width, is_signed ? bits.back() : kFalseLiteral);
  return bits;
}

Bits inverted(Bits bits) {
  for (Literal& bit : bits) bit = !bit;
  return bits;
}

Bits add(Circuit& circuit, const Bits& a, const Bits& b, Literal carry) {
  Bits sum(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    sum[i] = circuit.parity(a[i], b[i], carry);
    if (i + 1 < a.size()) carry = circuit.majority(a[i], b[i], carry);
  }
  return sum;
}

Bits subtract(Circuit& circuit, const Bits& a, const Bits& b) {
  return add(circuit, a, inverted(b), kTrueLiteral);
}

Bits exclusive_or(Circuit& circuit, const Bits& bits, Literal with) {
  Bits result(bits.size());
  for (std::size_t i = 0; i < bits.size(); ++i) result[i] = circuit.exclusive_or(bits[i], with);
  return result;
}

Bits negate_if(Circuit& circuit, Literal condition, const Bits& bits) {
  return add(circuit, exclusive_or(circuit, bits, condition), constant_bits(0, bits.size()), condition);
}

Bits select(Circuit& circuit, Literal condition, const Bits& a, const Bits& b) {
  Bits result(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) result[i] = circuit.mux(condition, a[i], b[i]);
  return result;
}

namespace {

Bits shifted(const Bits& bits, std::size_t by) {
  Bits result(bits.size(), kFalseLiteral);
  for (std::size_t i = by; i < bits.size(); ++i) result[i] = bits[i - by];
  return result;
}

Bits masked(Circuit& circuit, const Bits& bits, Literal mask) {
  Bits result(bits.size());
  for (std::size_t i = 0; i < bits.size(); ++i) result[i] = circuit.conjunction(bits[i], mask);
  return result;
}

}  // namespace

Bits multiply(Circuit& circuit, const Bits& a, const Bits& b, bool b_signed) {
  Bits product = constant_bits(0, a.size());
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    const Bits row = masked(circuit, shifted(a, i), b[i]);
    const bool is_sign = b_signed && i + 1 == b.size();
    product = is_sign ? subtract(circuit, product, row) : add(circuit, product, row);
  }
  return product;
}

/// Adds or subtracts a shifted copy of the number for each digit of the constant in non-adjacent form. Its
/// digits are -1, 0 and 1 (7 is 8 - 1), and at most half of them are not 0.
Bits multiply(Circuit& circuit, const Bits& a, std::int64_t constant) {
  Bits product = constant_bits(0, a.size());
  for (std::size_t i = 0; i < a.size() && constant != 0; ++i) {
    if (constant % 2 != 0) {
      const bool minus = (constant & 3) == 3;
      product = minus ? subtract(circuit, product, shifted(a, i)) : add(circuit, product, shifted(a, i));
      constant += minus ? 1 : -1;
    }
    constant /= 2;
  }
  return product;
}

Literal equal(Circuit& circuit, const Bits& a, const Bits& b) {
  Literal all = kTrueLiteral;
  for (std::size_t i = 0; i < a.size(); ++i) all = circuit.conjunction(all, circuit.equivalence(a[i], b[i]));
  return all;
}

Literal less(Circuit& circuit, const Bits& a, const Bits& b, bool or_equal) {
  Literal result = constant_literal(or_equal);
  for (std::size_t i = 0; i < a.size(); ++i) result = circuit.majority(!a[i], b[i], result);
  return result;
}

/// Does restoring division. What remains of the dividend's upper bits is always less than the divisor. With
/// the next bit shifted in it needs one bit more than the divisor has.
Division divide(Circuit& circuit, const Bits& a, const Bits& b) {
  const Bits divisor = resized(b, b.size() + 1, false);
  Bits quotient(a.size());
  Bits left = constant_bits(0, b.size());
  for (std::size_t i = a.size(); i-- > 0;) {
    left.insert(left.begin(), a[i]);
    quotient[i] = less(circuit, divisor, left, true);
    left = select(circuit, quotient[i], subtract(circuit, left, divisor), left);
    left.pop_back();
  }
  return {quotient, left};
}

}  // namespace solitaire
