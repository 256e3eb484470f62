#pragma once
#include <cstdint>
#include <vector>

#include "base/random.h"
#include "tracegraph/interval.h"
#include "tracegraph/scalar.h"
#include "tracegraph/weights.h"

namespace solitaire {

/// Says which values a choice can have, and how probable each is before any condition is looked at: its
/// domain and its prior in one. Solvers look at the domain (its support) alone.
///
/// Ints and bools of finite families have the values lo, lo + step, ... up to hi, where a bool is 0 or 1.
/// Counts have all ints from 0 to kMostCount. Floats have none of these three, but two parameters.
struct Distribution {
  enum class Family : std::uint8_t {
    kRange,        // an int of range(); each of its values is as probable as the others
    kFlip,         // a bool of flip(), true with probability `a`
    kIndex,        // a position in a list, from 0; each is as probable as the others, or as `weights` say
    kUniform,      // a float between `a` and `b`, with a constant density
    kNormal,       // a float with mean `a` and standard deviation `b`
    kNormalSharp,  // a float with mean `a` and precision `b`, which is 1 / the variance
    kExponential,  // a float above 0, with rate `a`
    kGamma,        // a float above 0, with shape `a` and rate `b`
    kBeta,         // a float between 0 and 1, both excluded, with shapes `a` and `b`
    kPoisson,      // a count with mean `a`
    kGeometric,    // the count of failures before the first success, each try succeeding with probability `a`
  };
  /// The largest count. What lies beyond has no probability to speak of, and ints stay within their range.
  static constexpr std::int64_t kMostCount = std::int64_t{1} << 31;

  std::int64_t lo = 0;
  std::int64_t hi = 0;
  std::int64_t step = 1;
  Family family = Family::kRange;
  double a = 0;
  double b = 0;
  Weights weights = {};  // of kIndex: one for each position, or none

  /// lo <= hi, step >= 1; hi need not be on a step.
  static Distribution range(std::int64_t lo, std::int64_t hi, std::int64_t step = 1) {
    return {lo, hi, step, Family::kRange, 0, 0, {}};
  }
  /// A position in a list of so many elements, at least 1.
  static Distribution index(std::int64_t count) { return {0, count - 1, 1, Family::kIndex, 0, 0, {}}; }
  /// A position, as probable as its weight is large. Weights are finite, none is negative, and one is not 0.
  static Distribution weighted(std::vector<double> weights);
  /// Returns the distribution of flip(), where 0 <= probability <= 1.
  static Distribution flip(double probability = 0.5) { return {0, 1, 1, Family::kFlip, probability, 0, {}}; }
  /// from < to, both finite.
  static Distribution uniform(double from, double to) { return of_floats(Family::kUniform, from, to); }
  /// deviation > 0, both finite.
  static Distribution normal(double mean, double deviation) {
    return of_floats(Family::kNormal, mean, deviation);
  }
  /// A family of floats or counts with its parameters, of which it takes one or two.
  static Distribution of_floats(Family family, double a, double b = 0) { return {0, 0, 1, family, a, b, {}}; }
  static Distribution of_counts(Family family, double a) { return {0, kMostCount, 1, family, a, 0, {}}; }

  Type type() const {
    if (family == Family::kFlip) return Type::kBool;
    return is_finite() || family >= Family::kPoisson ? Type::kInt : Type::kFloat;
  }
  /// Returns true if it has so few values that solvers and enumerations can go through them.
  bool is_finite() const { return family <= Family::kIndex; }

  /// Returns the number of values. Only for finite families.
  std::uint64_t size() const {
    return static_cast<std::uint64_t>(step == 1 ? hi - lo : (hi - lo) / step) + 1;
  }
  /// The value with that number, from 0. Only for finite families.
  std::int64_t value(std::uint64_t number) const { return lo + static_cast<std::int64_t>(number) * step; }
  /// The number of one of the values, from 0. Only for finite families.
  std::uint64_t number(std::int64_t value) const {
    return static_cast<std::uint64_t>(step == 1 ? value - lo : (value - lo) / step);
  }
  /// Returns the interval from the least to the largest value. Not for floats.
  Interval interval() const { return {lo, hi - (hi - lo) % step}; }
  /// Returns true if the int, or the bool as 0 or 1, is one of the values. Not for floats.
  bool contains(std::int64_t value) const {
    return lo <= value && value <= hi && (step == 1 || (value - lo) % step == 0);
  }
  /// Returns true if the value has the right type and can occur.
  bool contains(TypedScalar value) const {
    if (value.type() != type()) return false;
    return type() == Type::kFloat ? contains_float(value.as_float()) : contains(value.as_int());
  }
  bool contains_float(double value) const;
  /// An int of a solver as a value of this type. Only for finite families.
  TypedScalar typed(std::int64_t value) const { return {type(), Scalar::of(value)}; }

  /// A value drawn from the distribution. It depends on nothing but the stream.
  TypedScalar sample(RandomStream& stream) const;
  /// The natural logarithm of the value's probability, or of its density for a float; minus infinity for a
  /// value that cannot occur.
  double log_density(TypedScalar value) const;

  /// That of one value less that of another, both of which can occur, without what they have in common.
  double log_density_difference(TypedScalar value, TypedScalar other) const;

  friend bool operator==(const Distribution&, const Distribution&) = default;
};

}  // namespace solitaire
