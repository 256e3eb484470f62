#pragma once
#include <vector>

#include "solitaire/run/evaluator.h"

namespace solitaire {

/// An execution as the state of a chain.
struct SampledState {
  std::vector<MetChoice> choices;
  std::vector<double> log_priors;  // one for each choice
  double log_prior = 0;            // their sum
  double log_weight = 0;           // of factors and wishes; minus infinity where it is ruled out
  Value value;

  double log_density() const { return log_prior + log_weight; }
};

}  // namespace solitaire
