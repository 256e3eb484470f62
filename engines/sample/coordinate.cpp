#include "engines/sample/coordinate.h"

#include <cmath>

namespace solitaire {

using Family = Distribution::Family;

Coordinate::Coordinate(const Distribution& distribution) {
  switch (distribution.family) {
    case Family::kExponential:
    case Family::kGamma:
      kind_ = Kind::kLog;
      break;
    case Family::kBeta:
      kind_ = Kind::kLogOdds;
      break;
    case Family::kUniform:
      kind_ = Kind::kLogOdds;
      low_ = distribution.a;
      high_ = distribution.b;
      break;
    default:
      break;
  }
}

double Coordinate::of(double value) const {
  if (kind_ == Kind::kPlain) return value;
  return kind_ == Kind::kLog ? std::log(value) : std::log((value - low_) / (high_ - value));
}

double Coordinate::value(double at) const {
  if (kind_ == Kind::kPlain) return at;
  return kind_ == Kind::kLog ? std::exp(at) : low_ + (high_ - low_) / (1 + std::exp(-at));
}

double Coordinate::log_derivative(double value) const {
  if (kind_ == Kind::kPlain) return 0;
  if (kind_ == Kind::kLog) return std::log(value);
  return std::log((value - low_) * ((high_ - value) / (high_ - low_)));
}

Coordinate::Slopes Coordinate::slopes(double value) const {
  if (kind_ == Kind::kPlain) return {};
  if (kind_ == Kind::kLog) return {value, 1};
  const double share = (value - low_) / (high_ - low_);
  return {(value - low_) * (1 - share), 1 - 2 * share};
}

double usual_step(const Distribution& distribution) {
  switch (distribution.family) {
    case Family::kNormal:
      return 0.5 * distribution.b;
    case Family::kNormalSharp:
      return 0.5 / std::sqrt(distribution.b);
    default:
      return 0.5;
  }
}

}  // namespace solitaire
