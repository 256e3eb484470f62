#include "tracegraph/special_functions.h"

#include <cmath>
#include <limits>
#include <math.h>
#include <numbers>

namespace solitaire {

double log_gamma(double x) {
  int sign = 0;
  return ::lgamma_r(x, &sign);
}

/// Reflection for negative arguments, the recurrence up to 10, and from there the asymptotic series
/// (Abramowitz and Stegun 6.3.7, 6.3.5, 6.3.18), whose next term is below 1e-15.
double digamma(double x) {
  if (x <= 0) {
    if (x == std::floor(x)) return std::numeric_limits<double>::quiet_NaN();
    return digamma(1 - x) - std::numbers::pi / std::tan(std::numbers::pi * x);
  }
  double below = 0;
  while (x < 10) {
    below += 1 / x;
    x += 1;
  }
  const double t = 1 / (x * x);
  const double series =
      t * (1.0 / 12 - t * (1.0 / 120 - t * (1.0 / 252 - t * (1.0 / 240 - t * (1.0 / 132)))));
  return std::log(x) - 0.5 / x - series - below;
}

}  // namespace solitaire
