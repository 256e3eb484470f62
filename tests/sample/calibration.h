#pragma once
#include <cstdint>

#include "engines/sample/sampling.h"

namespace solitaire {

/// A program that draws an unknown `theta` and then `count` data, whose text is a list `y`. `prior` sets the
/// unknown, `datum` is an expression for one distribution of the data, such as "Normal(theta, 1)".
struct CalibratedModel {
  const char* prior;
  const char* draw;  // a datum, such as "normal(theta, 1)"
  const char* datum;
  std::uint32_t count;
  std::uint64_t warmup = 20;
};

/// Simulation-based calibration (Talts, Betancourt, Simpson, Vehtari and Gelman 2018): draws unknowns and
/// data from a program, then draws from the posterior given each of the data sets. The rank of the unknown
/// among these draws is uniform, whatever the program. Returns chi-squared of the ranks in eight bins, with 7
/// degrees of freedom, over so many data sets.
double calibration(const CalibratedModel& model, SamplingOptions::Engine engine, std::uint64_t seed,
                   std::uint32_t data_sets);

}  // namespace solitaire
