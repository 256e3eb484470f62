#pragma once
#include <bit>
#include <cmath>
#include <cstdint>

#include "base/random.h"

namespace solitaire {

/// Returns true if log(uniform) < log_ratio, for 0 < uniform < 1, and mostly without a logarithm: the number
/// lies between two powers of 2 whose logarithms say it already, unless the ratio lies between these, too.
inline bool accepts(double log_ratio, double uniform) {
  constexpr double kLogTwo = 0.693147180559945309417;
  constexpr double kRounding = 1e-9;
  const auto exponent = static_cast<int>(std::bit_cast<std::uint64_t>(uniform) >> 52) - 1023;
  const double low = exponent * kLogTwo;
  if (log_ratio < low - kRounding) return false;
  if (log_ratio > low + kLogTwo + kRounding) return true;
  return std::log(uniform) < log_ratio;
}

}  // namespace solitaire
