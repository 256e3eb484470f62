#include <cmath>
#include <fmt/format.h>
#include <solitaire/count.h>

namespace solitaire::api {
namespace {

/// Returns the number as "1.3e9", also where no double is so large.
std::string scientific(double log10) {
  double exponent = std::floor(log10);
  double mantissa = std::round(std::pow(10, log10 - exponent) * 10) / 10;
  if (mantissa >= 10) {
    mantissa /= 10;
    exponent += 1;
  }
  return fmt::format("{:.1f}e{:.0f}", mantissa, exponent);
}

std::string solutions(const std::string& digits) {
  return fmt::format("{} solution{}", digits, digits == "1" ? "" : "s");
}

}  // namespace

std::string to_text(const Count& count) {
  switch (count.kind) {
    case Count::Kind::kExact:
      return solutions(count.digits);
    case Count::Kind::kAtLeast:
      return "at least " + solutions(count.digits);
    case Count::Kind::kEstimate:
      break;
  }
  return fmt::format("about {} solutions (within a factor of {} with a confidence of {} %)",
                     scientific(count.log10), 1 + count.tolerance, 100 * count.confidence);
}

std::string to_json(const Count& count) {
  // This is written without the JSON library, as the number can have more digits than its number types.
  switch (count.kind) {
    case Count::Kind::kExact:
      return fmt::format("{{\"solutions\":{},\"exact\":true}}", count.digits);
    case Count::Kind::kAtLeast:
      return fmt::format("{{\"at_least\":{},\"exact\":false}}", count.digits);
    case Count::Kind::kEstimate:
      break;
  }
  return fmt::format("{{\"solutions\":{},\"exact\":false,\"tolerance\":{},\"confidence\":{}}}",
                     scientific(count.log10), count.tolerance, count.confidence);
}

}  // namespace solitaire::api
