#include "tracegraph/distribution.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace solitaire {
namespace {

constexpr double kImpossible = -std::numeric_limits<double>::infinity();

/// A standard normal number, by the method of Box and Muller (1958). Its second number is not kept, so that
/// each draw takes as much from the stream as any other.
double standard_normal(RandomStream& stream) {
  const double radius = std::sqrt(-2 * std::log(stream.uniform()));
  return radius * std::cos(2 * std::numbers::pi * stream.uniform());
}

}  // namespace

bool Distribution::contains(TypedScalar value) const {
  if (value.type() != type()) return false;
  switch (family) {
    case Family::kRange:
    case Family::kFlip:
    case Family::kIndex:
      return contains(value.as_int());
    case Family::kUniform:
      return a <= value.as_float() && value.as_float() <= b;
    case Family::kNormal:
      return std::isfinite(value.as_float());
  }
  return false;
}

TypedScalar Distribution::sample(RandomStream& stream) const {
  switch (family) {
    case Family::kRange:
    case Family::kIndex:
      return TypedScalar::of(value(stream.below(size())));
    case Family::kFlip:
      return TypedScalar::of(stream.uniform() < a);
    case Family::kUniform:
      return TypedScalar::of(a + (b - a) * stream.uniform());
    case Family::kNormal:
      return TypedScalar::of(a + b * standard_normal(stream));
  }
  return {};
}

double Distribution::log_density(TypedScalar value) const {
  if (!contains(value)) return kImpossible;
  switch (family) {
    case Family::kRange:
    case Family::kIndex:
      return -std::log(static_cast<double>(size()));
    case Family::kFlip:
      return std::log(value.as_int() != 0 ? a : 1 - a);
    case Family::kUniform:
      return -std::log(b - a);
    case Family::kNormal: {
      const double distance = (value.as_float() - a) / b;
      return -0.5 * distance * distance - std::log(b) - 0.5 * std::log(2 * std::numbers::pi);
    }
  }
  return kImpossible;
}

}  // namespace solitaire
