#include "engines/sample/coordinate.h"

#include <cmath>

namespace solitaire {

Coordinate coordinate_of(Distribution::Family family) {
  using Family = Distribution::Family;
  switch (family) {
    case Family::kExponential:
    case Family::kGamma:
      return Coordinate::kLog;
    case Family::kBeta:
      return Coordinate::kLogOdds;
    default:
      return Coordinate::kPlain;
  }
}

double to_coordinate(Coordinate coordinate, double value) {
  if (coordinate == Coordinate::kPlain) return value;
  return coordinate == Coordinate::kLog ? std::log(value) : std::log(value / (1 - value));
}

double from_coordinate(Coordinate coordinate, double at) {
  if (coordinate == Coordinate::kPlain) return at;
  return coordinate == Coordinate::kLog ? std::exp(at) : 1 / (1 + std::exp(-at));
}

double log_derivative(Coordinate coordinate, double value) {
  if (coordinate == Coordinate::kPlain) return 0;
  return coordinate == Coordinate::kLog ? std::log(value) : std::log(value * (1 - value));
}

double usual_step(const Distribution& distribution) {
  using Family = Distribution::Family;
  switch (distribution.family) {
    case Family::kUniform:
      return 0.2 * (distribution.b - distribution.a);
    case Family::kNormal:
      return 0.5 * distribution.b;
    case Family::kNormalSharp:
      return 0.5 / std::sqrt(distribution.b);
    default:
      return 0.5;
  }
}

}  // namespace solitaire
