#pragma once
#include <cstdint>

namespace solitaire {

/// Returns a / b, rounded down, as the language divides ints. b is not 0.
constexpr std::int64_t floor_divide(std::int64_t a, std::int64_t b) {
  return a / b - ((a % b != 0 && (a < 0) != (b < 0)) ? 1 : 0);
}

/// Returns the rest of that division, which has the sign of b. b is not 0.
constexpr std::int64_t floor_modulo(std::int64_t a, std::int64_t b) {
  const std::int64_t rest = a % b;
  return (rest != 0 && (a < 0) != (b < 0)) ? rest + b : rest;
}

}  // namespace solitaire
