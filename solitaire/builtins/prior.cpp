#include "solitaire/builtins/prior.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

#include "solitaire/value/plain_value.h"

namespace solitaire {
namespace {

using Family = Distribution::Family;

bool keeps(ParameterRule rule, double value) {
  switch (rule) {
    case ParameterRule::kAny:
      return true;
    case ParameterRule::kPositive:
      return value > 0;
    case ParameterRule::kProbability:
      return 0 <= value && value <= 1;
    case ParameterRule::kPositiveProbability:
      return 0 < value && value <= 1;
  }
  return false;
}

const char* rule_words(ParameterRule rule) {
  switch (rule) {
    case ParameterRule::kAny:
      return "a number";
    case ParameterRule::kPositive:
      return "a positive number";
    case ParameterRule::kProbability:
      return "a number from 0 to 1";
    case ParameterRule::kPositiveProbability:
      return "a number above 0, up to 1";
  }
  return "";
}

Distribution distribution_of(Family family, std::span<const double> numbers) {
  switch (family) {
    case Family::kFlip:
      return Distribution::flip(numbers[0]);
    case Family::kPoisson:
    case Family::kGeometric:
      return Distribution::of_counts(family, numbers[0]);
    default:
      return Distribution::of_floats(family, numbers[0], numbers.size() > 1 ? numbers[1] : 0);
  }
}

/// The mean of counts that are drawn. Larger ones could lie past the largest count that there is.
constexpr double kMostMeanCount = 1 << 26;

bool draws_too_large_counts(Family family, double parameter) {
  if (family == Family::kPoisson) return parameter > kMostMeanCount;
  return family == Family::kGeometric && parameter * kMostMeanCount < 1;
}

/// Where a parameter stands: an argument of the call that draws, or else the whole call.
Span parameter_span(const CallExpr& site, const DistributionRow& row, std::size_t number) {
  for (std::size_t i = 0; i < site.arguments.size(); ++i) {
    const Argument& argument = site.arguments[i];
    if (argument.name.empty() ? i == number : argument.name == row.parameters[number].name)
      return argument.value->span;
  }
  return site.span;
}

}  // namespace

const std::vector<DistributionRow>& distribution_rows() {
  using enum ParameterRule;
  static const std::vector<DistributionRow> table = {
      {"flip", "Flip", Family::kFlip, {{"probability", kProbability}}},
      {"uniform", "Uniform", Family::kUniform, {{"lo", kAny}, {"hi", kAny}}},
      {"normal", "Normal", Family::kNormal, {{"mean", kAny}, {"sd", kPositive}}},
      {"normal", "Normal", Family::kNormalSharp, {{"mean", kAny}, {"precision", kPositive}}},
      {"exponential", "Exponential", Family::kExponential, {{"rate", kPositive}}},
      {"gamma", "Gamma", Family::kGamma, {{"shape", kPositive}, {"rate", kPositive}}},
      {"beta", "Beta", Family::kBeta, {{"a", kPositive}, {"b", kPositive}}},
      {"poisson", "Poisson", Family::kPoisson, {{"rate", kPositive}}},
      {"geometric", "Geometric", Family::kGeometric, {{"probability", kPositiveProbability}}},
  };
  return table;
}

const DistributionRow& distribution_row(Family family) {
  return *std::find_if(distribution_rows().begin(), distribution_rows().end(),
                       [=](const DistributionRow& row) { return row.family == family; });
}

double known_number(Evaluator& evaluator, const Value& value, const char* of, Span span) {
  if (!value.is_number() && value.as_union() == nullptr)
    evaluator.program_error(span, fmt::format("'{}' needs numbers, not {}", of, describe(value)));
  if (!is_known(value)) {
    evaluator.unsupported(span, fmt::format("this parameter of '{}' depends on choices", of),
                          "give the distribution constant parameters, or draw it by 'solitaire sample'");
  }
  const auto* i = value.get<std::int64_t>();
  const double known = i != nullptr ? static_cast<double>(*i) : *value.get<double>();
  if (!std::isfinite(known)) evaluator.program_error(span, fmt::format("'{}' needs finite numbers", of));
  return known;
}

/// Where the parameters are traced, what they may be is checked of their present values alone: whoever runs
/// on the trace runs what it shows again.
Prior prior_of(Evaluator& evaluator, const DistributionRow& row, std::span<const Value> values,
               const CallExpr& site, bool drawing) {
  std::array<double, 2> numbers{};
  for (std::size_t i = 0; i < row.parameters.size(); ++i) {
    const auto& [name, rule] = row.parameters[i];
    const Span span = drawing ? parameter_span(site, row, i) : site.span;
    numbers[i] = known_number(evaluator, values[i], row.draw, span);
    if (!keeps(rule, numbers[i])) {
      evaluator.program_error(span, fmt::format("the {} of '{}' is {}, not {}", name, row.draw,
                                                rule_words(rule), float_text(numbers[i])));
    }
  }
  if (drawing && draws_too_large_counts(row.family, numbers[0])) {
    evaluator.program_error(
        parameter_span(site, row, 0),
        fmt::format("the counts of '{}' would be too large: with a {} of {}, their mean is above 2^26",
                    row.draw, row.parameters[0].name, float_text(numbers[0])));
  }
  if (row.family == Family::kUniform && numbers[0] >= numbers[1])
    evaluator.program_error(site.span, "'uniform' needs a first number that is below the second");
  const auto count = row.parameters.size();
  return {distribution_of(row.family, {numbers.data(), count}),
          {values.begin(), values.begin() + static_cast<std::ptrdiff_t>(count)}};
}

Prior weighted_prior(Evaluator& evaluator, std::span<const Value> items, const char* of, Span span) {
  std::vector<double> weights;
  double sum = 0;
  for (const Value& item : items) {
    weights.push_back(known_number(evaluator, item, of, span));
    if (weights.back() < 0)
      evaluator.program_error(
          span, fmt::format("a weight of '{}' is negative: {}", of, float_text(weights.back())));
    sum += weights.back();
  }
  if (!(sum > 0)) evaluator.program_error(span, fmt::format("no weight of '{}' is above 0", of));
  return {Distribution::weighted(std::move(weights)), {items.begin(), items.end()}};
}

}  // namespace solitaire
