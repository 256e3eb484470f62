#pragma once
#include <cmath>

#include "tracegraph/scalar.h"

// What both machines of the kernel call for operations that are no instruction of a processor.

namespace solitaire {

/// The quotient is rounded down; of a division by 0 it is 0, and so is the rest.
inline std::int64_t floor_divide(std::int64_t a, std::int64_t b) {
  if (b == 0) return 0;
  return a / b - ((a % b != 0 && (a < 0) != (b < 0)) ? 1 : 0);
}

inline std::int64_t floor_modulo(std::int64_t a, std::int64_t b) {
  if (b == 0) return 0;
  const std::int64_t rest = a % b;
  return (rest != 0 && (a < 0) != (b < 0)) ? rest + b : rest;
}

/// Returns false, and gives 0, where the int would be past 2^53.
inline bool floor_into(double value, Scalar* result) {
  constexpr double kLimit = 9007199254740992.0;
  const double floor = std::floor(value);
  const bool exact = std::abs(floor) <= kLimit;
  result->i = exact ? static_cast<std::int64_t>(floor) : 0;
  return exact;
}

}  // namespace solitaire
