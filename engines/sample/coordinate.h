#pragma once
#include <cstdint>

#include "tracegraph/distribution.h"

namespace solitaire {

/// The coordinate in which a float walks: itself, its logarithm or its log odds, so that it stays where its
/// family has it.
enum class Coordinate : std::uint8_t { kPlain, kLog, kLogOdds };

Coordinate coordinate_of(Distribution::Family family);
double to_coordinate(Coordinate coordinate, double value);
double from_coordinate(Coordinate coordinate, double at);
/// The logarithm of the derivative of the value by the coordinate, where the value is that.
double log_derivative(Coordinate coordinate, double value);

/// How far a float may go in its coordinate before anything is known but its distribution.
double usual_step(const Distribution& distribution);

}  // namespace solitaire
