#include "tracegraph/distribution.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "tracegraph/drawing.h"
#include "tracegraph/special_functions.h"

namespace solitaire {
namespace {

constexpr double kImpossible = -std::numeric_limits<double>::infinity();
constexpr double kLogTwoPi = 1.8378770664093454836;

double sum(const std::vector<double>& weights) {
  return std::accumulate(weights.begin(), weights.end(), 0.0);
}

double log_beta(double a, double b) { return log_gamma(a) + log_gamma(b) - log_gamma(a + b); }

}  // namespace

Distribution Distribution::weighted(std::vector<double> weights) {
  Distribution made = index(static_cast<std::int64_t>(weights.size()));
  made.weights = Weights(std::move(weights));
  return made;
}

bool Distribution::contains_float(double x) const {
  switch (family) {
    case Family::kUniform:
      return a <= x && x <= b;
    case Family::kExponential:
    case Family::kGamma:
      return x > 0 && std::isfinite(x);
    case Family::kBeta:
      return 0 < x && x < 1;
    default:
      return std::isfinite(x);
  }
}

TypedScalar Distribution::sample(RandomStream& stream) const {
  switch (family) {
    case Family::kRange:
      return TypedScalar::of(value(stream.below(size())));
    case Family::kIndex:
      if (weights.empty()) return TypedScalar::of(value(stream.below(size())));
      return TypedScalar::of(
          static_cast<std::int64_t>(draw_index(weights.list(), sum(weights.list()), stream)));
    case Family::kFlip:
      return TypedScalar::of(stream.uniform() < a);
    case Family::kUniform:
      return TypedScalar::of(a + (b - a) * stream.uniform());
    case Family::kNormal:
      return TypedScalar::of(a + b * draw_normal(stream));
    case Family::kNormalSharp:
      return TypedScalar::of(a + draw_normal(stream) / std::sqrt(b));
    case Family::kExponential:
      return TypedScalar::of(-std::log(stream.uniform()) / a);
    case Family::kGamma:
      return TypedScalar::of(draw_gamma(a, b, stream));
    case Family::kBeta:
      return TypedScalar::of(draw_beta(a, b, stream));
    case Family::kPoisson:
      return TypedScalar::of(std::min(draw_poisson(a, stream), kMostCount));
    case Family::kGeometric:
      return TypedScalar::of(std::min(draw_geometric(a, stream), kMostCount));
  }
  return {};
}

double Distribution::log_density(TypedScalar value) const {
  if (!contains(value)) return kImpossible;
  const double x = value.as_float();
  switch (family) {
    case Family::kRange:
      return -std::log(static_cast<double>(size()));
    case Family::kIndex:
      if (weights.empty()) return -std::log(static_cast<double>(size()));
      return std::log(weights[static_cast<std::size_t>(value.as_int())] / sum(weights.list()));
    case Family::kFlip:
      return std::log(value.as_int() != 0 ? a : 1 - a);
    case Family::kUniform:
      return -std::log(b - a);
    case Family::kNormal: {
      const double distance = (x - a) / b;
      return -0.5 * distance * distance - std::log(b) - 0.5 * kLogTwoPi;
    }
    case Family::kNormalSharp:
      return -0.5 * b * ((x - a) * (x - a)) + 0.5 * std::log(b) - 0.5 * kLogTwoPi;
    case Family::kExponential:
      return std::log(a) - a * x;
    case Family::kGamma:
      return (a - 1) * std::log(x) - b * x + a * std::log(b) - log_gamma(a);
    case Family::kBeta:
      return (a - 1) * std::log(x) + (b - 1) * std::log(1 - x) - log_beta(a, b);
    case Family::kPoisson:
      return x * std::log(a) - a - log_gamma(x + 1);
    case Family::kGeometric:
      return std::log(a) + (x > 0 ? x * std::log(1 - a) : 0);
  }
  return kImpossible;
}

double Distribution::log_density_difference(TypedScalar value, TypedScalar other) const {
  const double x = value.as_float(), y = other.as_float();
  switch (family) {
    case Family::kUniform:
      return 0;
    case Family::kNormal: {
      const double of_x = (x - a) / b, of_y = (y - a) / b;
      return 0.5 * (of_y * of_y - of_x * of_x);
    }
    case Family::kNormalSharp:
      return 0.5 * b * ((y - a) * (y - a) - (x - a) * (x - a));
    case Family::kExponential:
      return a * (y - x);
    default:
      return log_density(value) - log_density(other);
  }
}

}  // namespace solitaire
