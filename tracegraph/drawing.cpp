#include "tracegraph/drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "tracegraph/special_functions.h"

namespace solitaire {
namespace {

constexpr double kLeast = std::numeric_limits<double>::min();
constexpr double kLargestCount = 4611686018427387904.0;  // 2^62

/// Standard normal numbers from layers of equal area that lie on each other and cover the density: Marsaglia
/// and Tsang, "The ziggurat method for generating random variables" (2000); with bits for the layer that the
/// number does not have, after Doornik, "An improved ziggurat method to generate normal random samples"
/// (2005).
class Ziggurat {
 public:
  Ziggurat() {
    width_[0] = kArea / density(kEnd);
    width_[1] = kEnd;
    for (std::size_t i = 2; i < kLayers; ++i)
      width_[i] = std::sqrt(-2 * std::log(kArea / width_[i - 1] + density(width_[i - 1])));
    width_[kLayers] = 0;
  }

  double draw(RandomStream& stream) const {
    while (true) {
      const std::uint64_t bits = stream.next();
      const std::size_t layer = bits % kLayers;
      const double x = width_[layer] * (static_cast<double>(bits >> 11) * 0x1p-52 - 1);
      if (std::abs(x) < width_[layer + 1]) return x;
      if (layer == 0) return std::copysign(beyond_end(stream), x);
      const double low = density(width_[layer]), high = density(width_[layer + 1]);
      if (low + stream.uniform() * (high - low) < density(x)) return x;
    }
  }

 private:
  static constexpr std::size_t kLayers = 128;
  static constexpr double kEnd = 3.442619855899;        // where the lowest layer has its tail
  static constexpr double kArea = 9.91256303526217e-3;  // of a layer

  static double density(double x) { return std::exp(-0.5 * x * x); }
  /// By Marsaglia's method for tails (1964).
  static double beyond_end(RandomStream& stream) {
    while (true) {
      const double x = -std::log(stream.uniform()) / kEnd;
      const double y = -std::log(stream.uniform());
      if (2 * y > x * x) return kEnd + x;
    }
  }

  std::array<double, kLayers + 1> width_;
};

/// A number of Gamma(shape, 1) as its logarithm, for shapes below 1 too small to be a float: Marsaglia and
/// Tsang, "A simple method for generating gamma variables" (2000).
double log_standard_gamma(double shape, RandomStream& stream) {
  if (shape < 1) return log_standard_gamma(shape + 1, stream) + std::log(stream.uniform()) / shape;
  const double d = shape - 1.0 / 3;
  const double c = 1 / std::sqrt(9 * d);
  while (true) {
    const double x = draw_normal(stream);
    const double root = 1 + c * x;
    if (root <= 0) continue;
    const double v = root * root * root;
    if (std::log(stream.uniform()) < 0.5 * x * x + d - d * v + d * std::log(v)) return std::log(d * v);
  }
}

/// By the product of uniform numbers (Knuth, section 3.4.1); its time grows with the mean.
std::int64_t small_poisson(double mean, RandomStream& stream) {
  const double limit = std::exp(-mean);
  std::int64_t count = 0;
  for (double product = stream.uniform(); product > limit; product *= stream.uniform()) ++count;
  return count;
}

/// By transformed rejection: Hörmann, "The transformed rejection method for generating Poisson random
/// variables" (1993), algorithm PTRS, for means from 10.
std::int64_t large_poisson(double mean, RandomStream& stream) {
  const double b = 0.931 + 2.53 * std::sqrt(mean);
  const double a = -0.059 + 0.02483 * b;
  const double inverse_alpha = 1.1239 + 1.1328 / (b - 3.4);
  const double inside = 0.9277 - 3.6224 / (b - 2);
  while (true) {
    const double u = stream.uniform() - 0.5;
    const double v = stream.uniform();
    const double margin = 0.5 - std::abs(u);
    const double k = std::floor((2 * a / margin + b) * u + mean + 0.43);
    if (k < 0 || k > kLargestCount) continue;
    if (margin >= 0.07 && v <= inside) return static_cast<std::int64_t>(k);
    if (margin < 0.013 && v > margin) continue;
    if (std::log(v * inverse_alpha / (a / (margin * margin) + b)) <=
        k * std::log(mean) - mean - log_gamma(k + 1))
      return static_cast<std::int64_t>(k);
  }
}

}  // namespace

double draw_normal(RandomStream& stream) {
  static const Ziggurat ziggurat;
  return ziggurat.draw(stream);
}

double draw_gamma(double shape, double rate, RandomStream& stream) {
  const double value = std::exp(log_standard_gamma(shape, stream)) / rate;
  return std::clamp(value, kLeast, std::numeric_limits<double>::max());
}

double draw_beta(double a, double b, RandomStream& stream) {
  const double x = log_standard_gamma(a, stream);
  const double y = log_standard_gamma(b, stream);
  return std::clamp(1 / (1 + std::exp(y - x)), kLeast, 1 - std::numeric_limits<double>::epsilon() / 2);
}

std::int64_t draw_poisson(double mean, RandomStream& stream) {
  if (mean >= kLargestCount) return static_cast<std::int64_t>(kLargestCount);
  return mean < 10 ? small_poisson(mean, stream) : large_poisson(mean, stream);
}

std::int64_t draw_geometric(double probability, RandomStream& stream) {
  if (probability >= 1) return 0;
  const double tries = std::floor(std::log(stream.uniform()) / std::log1p(-probability));
  return static_cast<std::int64_t>(std::min(tries, kLargestCount));
}

std::size_t draw_index(std::span<const double> weights, double sum, RandomStream& stream) {
  double left = stream.uniform() * sum;
  std::size_t last = 0;  // of the positions that can be drawn, for sums that rounding made too large
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (weights[i] <= 0) continue;
    last = i;
    if (left < weights[i]) return i;
    left -= weights[i];
  }
  return last;
}

}  // namespace solitaire
