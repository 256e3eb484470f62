#pragma once
#include <cmath>
#include <cstdint>
#include <doctest/doctest.h>
#include <map>
#include <string>

namespace solitaire {

/// How often what was drawn, among everything that there is.
using DrawCounts = std::map<std::string, std::uint64_t>;

/// Whether what was drawn is so uneven as it would be for one in about 30 000 fair draws.
inline bool uneven(const DrawCounts& tally) {
  double drawn = 0;
  for (const auto& [key, times] : tally) drawn += static_cast<double>(times);
  const double expected = drawn / static_cast<double>(tally.size());
  REQUIRE(expected >= 5);
  double sum = 0;
  for (const auto& [key, times] : tally) sum += std::pow(static_cast<double>(times) - expected, 2) / expected;
  // Wilson and Hilferty's approximation of the chi-square distribution.
  const double freedom = static_cast<double>(tally.size()) - 1;
  const double normal = (std::cbrt(sum / freedom) - (1 - 2 / (9 * freedom))) / std::sqrt(2 / (9 * freedom));
  INFO("chi square ", sum, " for ", freedom, " degrees of freedom");
  return normal > 4;
}

}  // namespace solitaire
