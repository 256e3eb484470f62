#pragma once
#include <string>

#include "engines/sample/sampling.h"

namespace solitaire {

/// How far the frequencies of a chain are from what enumeration says, at most.
struct Deviation {
  double errors = 0;  // in standard errors of drawing
  std::string value;  // of the program, where it is
};

/// Runs one chain of a program that returns an int and whose choices are finite.
Deviation worst_deviation(const Program& program, const SamplingOptions& options);

}  // namespace solitaire
