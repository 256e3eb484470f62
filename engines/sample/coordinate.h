#pragma once
#include <cstdint>

#include "tracegraph/distribution.h"

namespace solitaire {

/// The coordinate in which a float walks: itself, its logarithm, or the log odds of its place between two
/// ends, so that it stays where its distribution has it.
class Coordinate {
 public:
  /// The float itself.
  Coordinate() = default;
  /// A coordinate that never leads out of what the distribution can be, with the parameters that it has.
  explicit Coordinate(const Distribution& distribution);

  double of(double value) const;
  double value(double at) const;
  /// The logarithm of the derivative of the value by the coordinate, where the value is that.
  double log_derivative(double value) const;

  /// By how much a value, and the logarithm of that derivative, grow with the coordinate.
  struct Slopes {
    double value = 1;
    double log_derivative = 0;
  };
  Slopes slopes(double value) const;

 private:
  enum class Kind : std::uint8_t { kPlain, kLog, kLogOdds };
  Kind kind_ = Kind::kPlain;
  double low_ = 0, high_ = 1;  // the ends, for log odds
};

/// How far a float may go in its coordinate before anything is known but its distribution.
double usual_step(const Distribution& distribution);

}  // namespace solitaire
