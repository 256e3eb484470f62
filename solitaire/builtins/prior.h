#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "solitaire/run/evaluation.h"

// What the builtins about distributions share: their table, and how parameters are read.

namespace solitaire {

/// What a parameter can be.
enum class ParameterRule : std::uint8_t { kAny, kPositive, kProbability, kPositiveProbability };

struct ParameterRow {
  const char* name;
  ParameterRule rule;
};

/// A distribution of the language: its choice `draw`, and `record`, which makes it a value.
struct DistributionRow {
  const char* draw;
  const char* record;
  Distribution::Family family;
  std::vector<ParameterRow> parameters;
};

/// All of them but those whose parameter is a list.
const std::vector<DistributionRow>& distribution_rows();
/// The first row of the family.
const DistributionRow& distribution_row(Distribution::Family family);

/// A finite number that does not depend on open choices; an error of the program, called `of`, if it is none.
double known_number(Evaluator& evaluator, const Value& value, const char* of, Span span);

/// The distribution of a row with these parameters, which are checked. `drawing` is true if they are the
/// arguments of the call, and so stand there for messages.
Prior prior_of(Evaluator& evaluator, const DistributionRow& row, std::span<const Value> values,
               const CallExpr& site, bool drawing);
/// A distribution over positions with these weights, of which one is not 0.
Prior weighted_prior(Evaluator& evaluator, std::span<const Value> weights, const char* of, Span span);

}  // namespace solitaire
