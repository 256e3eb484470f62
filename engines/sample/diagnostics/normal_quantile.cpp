#include "engines/sample/diagnostics/normal_quantile.h"

#include <cmath>
#include <numbers>

namespace solitaire {
namespace {

/// Abramowitz and Stegun 26.2.23, with an error below 4.5e-4, for shares up to a half.
double rough_lower_quantile(double share) {
  const double t = std::sqrt(-2 * std::log(share));
  const double above = 2.515517 + t * (0.802853 + t * 0.010328);
  const double below = 1 + t * (1.432788 + t * (0.189269 + t * 0.001308));
  return above / below - t;
}

double lower_quantile(double share) {
  double x = rough_lower_quantile(share);
  // Newton's method on the distribution function, improved by Halley's; two steps leave rounding alone.
  for (int i = 0; i < 2; ++i) {
    const double error = 0.5 * std::erfc(-x / std::numbers::sqrt2) - share;
    const double density = std::exp(-0.5 * x * x) / std::sqrt(2 * std::numbers::pi);
    const double step = error / density;
    x -= step / (1 + 0.5 * x * step);
  }
  return x;
}

}  // namespace

double normal_quantile(double share) {
  return share <= 0.5 ? lower_quantile(share) : -lower_quantile(1 - share);
}

}  // namespace solitaire
