#include "engines/sample/shred/conditional.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "engines/tuning.h"
#include "tracegraph/drawing.h"

namespace solitaire {
namespace {

/// How much the logarithm of the density changes where the choice has that value: minus infinity where it is
/// impossible.
double score_at(Kernel& kernel, ChoiceNumber choice, Scalar value) {
  return kernel.propose(choice, value) == Kernel::Outcome::kScored ? kernel.difference() : -HUGE_VAL;
}

double score_at(Kernel& kernel, ChoiceNumber choice, double value) {
  return score_at(kernel, choice, Scalar::of(value));
}

/// The width of the prior, as a distance at which a parabola is looked at.
double prior_width(const Distribution& distribution) {
  return distribution.family == Distribution::Family::kNormal ? distribution.b
                                                              : 1 / std::sqrt(distribution.b);
}

/// The score is d(c + x) = g x + h x^2 / 2, so g and h follow from two differences.
std::optional<Scalar> draw_normal_form(Kernel& kernel, ChoiceNumber choice, RandomStream& stream) {
  const double c = kernel.value(choice).f;
  const double s = prior_width(kernel.domain(choice));
  const double up = score_at(kernel, choice, c + s);
  const double down = score_at(kernel, choice, c - s);
  const double slope = (up - down) / (2 * s);
  const double curvature = (up + down) / (s * s);
  if (!(curvature < 0) || !std::isfinite(slope) || !std::isfinite(curvature)) return std::nullopt;
  return Scalar::of(c - slope / curvature + draw_normal(stream) / std::sqrt(-curvature));
}

/// The score is A log c - B c and a constant, so A and B follow from two differences, at c e^0.5 and c
/// e^-0.5.
std::optional<Scalar> draw_gamma_form(Kernel& kernel, ChoiceNumber choice, RandomStream& stream) {
  const double c = kernel.value(choice).f;
  const double factor = std::exp(0.5);
  const double up = score_at(kernel, choice, c * factor);
  const double down = score_at(kernel, choice, c / factor);
  const double rate = -(up + down) / (c * (factor + 1 / factor - 2));
  const double power = 2 * (up + rate * c * (factor - 1));
  if (!(rate > 0) || !(power > -1) || !std::isfinite(rate) || !std::isfinite(power)) return std::nullopt;
  return Scalar::of(draw_gamma(power + 1, rate, stream));
}

/// The score is A log c + B log(1 - c) and a constant. The two values that are looked at have odds e times
/// larger and smaller.
std::optional<Scalar> draw_beta_form(Kernel& kernel, ChoiceNumber choice, RandomStream& stream) {
  const double c = kernel.value(choice).f;
  const auto with_odds = [&](double factor) { return factor * c / (factor * c + (1 - c)); };
  const double high = with_odds(std::exp(1.0));
  const double low = with_odds(std::exp(-1.0));
  const double a1 = std::log(high / c), b1 = std::log((1 - high) / (1 - c));
  const double a2 = std::log(low / c), b2 = std::log((1 - low) / (1 - c));
  const double up = score_at(kernel, choice, high);
  const double down = score_at(kernel, choice, low);
  const double determinant = a1 * b2 - a2 * b1;
  const double a = (up * b2 - down * b1) / determinant;
  const double b = (a1 * down - a2 * up) / determinant;
  if (!(a > -1) || !(b > -1) || !std::isfinite(a) || !std::isfinite(b)) return std::nullopt;
  return Scalar::of(draw_beta(a + 1, b + 1, stream));
}

}  // namespace

std::optional<Scalar> draw_of_form(Kernel& kernel, ChoiceNumber choice, Form form, RandomStream& stream) {
  switch (form) {
    case Form::kNormal:
      return draw_normal_form(kernel, choice, stream);
    case Form::kGamma:
      return draw_gamma_form(kernel, choice, stream);
    case Form::kBeta:
      return draw_beta_form(kernel, choice, stream);
    case Form::kUnknown:
      break;
  }
  return std::nullopt;
}

Scalar draw_of_few(Kernel& kernel, ChoiceNumber choice, const Distribution& distribution,
                   RandomStream& stream) {
  std::array<double, tuning::kMostValuesCompared> room;
  const std::span<double> scores(room.data(), distribution.size());
  for (std::uint64_t i = 0; i < distribution.size(); ++i) {
    const Scalar value = Scalar::of(distribution.value(i));
    const bool present = value.i == kernel.value(choice).i;
    scores[i] = present ? 0 : score_at(kernel, choice, value);
  }
  const double best = *std::max_element(scores.begin(), scores.end());
  double sum = 0;
  for (double& score : scores) sum += score = std::exp(score - best);
  return Scalar::of(distribution.value(draw_index(scores, sum, stream)));
}

}  // namespace solitaire
