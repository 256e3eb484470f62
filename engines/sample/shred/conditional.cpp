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

/// The logarithm of the density is b c + a c^2.
std::optional<Scalar> draw_normal_form(std::span<const double> numbers, RandomStream& stream) {
  const double b = numbers[0], a = numbers[1];
  if (!(a < 0) || !std::isfinite(a) || !std::isfinite(b)) return std::nullopt;
  return Scalar::of(b / (-2 * a) + draw_normal(stream) / std::sqrt(-2 * a));
}

/// It is a log c + b c.
std::optional<Scalar> draw_gamma_form(std::span<const double> numbers, RandomStream& stream) {
  const double a = numbers[0], b = numbers[1];
  if (!(b < 0) || !(a > -1) || !std::isfinite(a) || !std::isfinite(b)) return std::nullopt;
  return Scalar::of(draw_gamma(a + 1, -b, stream));
}

/// It is a log c + b log(1 - c).
std::optional<Scalar> draw_beta_form(std::span<const double> numbers, RandomStream& stream) {
  const double a = numbers[0], b = numbers[1];
  if (!(a > -1) || !(b > -1) || !std::isfinite(a) || !std::isfinite(b)) return std::nullopt;
  return Scalar::of(draw_beta(a + 1, b + 1, stream));
}

/// The number of a value, by weights whose logarithms are given, of which one is finite.
std::size_t draw_of_weights(std::span<const double> log_weights, RandomStream& stream) {
  std::array<double, tuning::kMostValuesCompared> room;
  const std::span<double> weights(room.data(), log_weights.size());
  const double best = *std::max_element(log_weights.begin(), log_weights.end());
  double sum = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) sum += weights[i] = std::exp(log_weights[i] - best);
  return draw_index(weights, sum, stream);
}

}  // namespace

std::optional<Scalar> draw_of_form(Kernel& kernel, ChoiceNumber choice, RandomStream& stream) {
  const ScoreProgram::Choice& at = kernel.program().choices[choice];
  const std::span<const double> numbers = kernel.numbers(choice);
  switch (at.form) {
    case Form::kNormal:
      return draw_normal_form(numbers, stream);
    case Form::kGamma:
      return draw_gamma_form(numbers, stream);
    case Form::kBeta:
      return draw_beta_form(numbers, stream);
    case Form::kWeights:
      return Scalar::of(at.distribution.value(draw_of_weights(numbers, stream)));
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
  return Scalar::of(distribution.value(draw_of_weights(scores, stream)));
}

}  // namespace solitaire
