#pragma once
#include <cstdint>

#include "base/random.h"
#include "tracegraph/interval.h"
#include "tracegraph/scalar.h"

namespace solitaire {

/// What a choice can be, and how probable each value is before any condition is looked at: its domain and its
/// prior in one. Solvers look at the domain (its support) alone.
///
/// Ints and bools have finitely many values: lo, lo + step, ... up to hi, where a bool is 0 or 1. Floats have
/// none of these three, but two parameters.
struct Distribution {
  enum class Family : std::uint8_t {
    kRange,    // an int of range(); each of its values is as probable as the others
    kFlip,     // a bool of flip(), true with probability `a`
    kIndex,    // a position in the list given to choose(), from 0; each is as probable as the others
    kUniform,  // a float between `a` and `b`, with a constant density
    kNormal,   // a float with mean `a` and standard deviation `b`
  };

  std::int64_t lo = 0;
  std::int64_t hi = 0;
  std::int64_t step = 1;
  Family family = Family::kRange;
  double a = 0;
  double b = 0;

  /// lo <= hi, step >= 1; hi need not be on a step.
  static constexpr Distribution range(std::int64_t lo, std::int64_t hi, std::int64_t step = 1) {
    return {lo, hi, step, Family::kRange, 0, 0};
  }
  /// A position in a list of so many elements, at least 1.
  static constexpr Distribution index(std::int64_t count) { return {0, count - 1, 1, Family::kIndex, 0, 0}; }
  /// 0 <= probability <= 1.
  static constexpr Distribution flip(double probability = 0.5) {
    return {0, 1, 1, Family::kFlip, probability, 0};
  }
  /// from < to, both finite.
  static constexpr Distribution uniform(double from, double to) {
    return {0, 0, 1, Family::kUniform, from, to};
  }
  /// deviation > 0, both finite.
  static constexpr Distribution normal(double mean, double deviation) {
    return {0, 0, 1, Family::kNormal, mean, deviation};
  }

  constexpr Type type() const {
    if (family == Family::kFlip) return Type::kBool;
    return is_finite() ? Type::kInt : Type::kFloat;
  }
  /// Returns true if it has finitely many values, so that solvers and enumerations can go through them.
  constexpr bool is_finite() const { return family != Family::kUniform && family != Family::kNormal; }

  /// How many values there are. Only for finite families.
  constexpr std::uint64_t size() const { return static_cast<std::uint64_t>((hi - lo) / step) + 1; }
  /// The value with that number, from 0. Only for finite families.
  constexpr std::int64_t value(std::uint64_t number) const {
    return lo + static_cast<std::int64_t>(number) * step;
  }
  /// From the least to the largest value. Only for finite families.
  constexpr Interval interval() const { return {lo, hi - (hi - lo) % step}; }
  /// Whether the int, or the bool as 0 or 1, is one of the values. Only for finite families.
  constexpr bool contains(std::int64_t value) const {
    return lo <= value && value <= hi && (value - lo) % step == 0;
  }
  /// Whether the value has the right type and can occur.
  bool contains(TypedScalar value) const;
  /// An int of a solver as a value of this type. Only for finite families.
  constexpr TypedScalar typed(std::int64_t value) const { return {type(), Scalar::of(value)}; }

  /// A value drawn from the distribution. It depends on nothing but the stream.
  TypedScalar sample(RandomStream& stream) const;
  /// The natural logarithm of the value's probability, or of its density for a float; minus infinity for a
  /// value that cannot occur.
  double log_density(TypedScalar value) const;

  friend bool operator==(const Distribution&, const Distribution&) = default;
};

}  // namespace solitaire
