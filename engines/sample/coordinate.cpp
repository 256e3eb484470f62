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

}  // namespace solitaire
