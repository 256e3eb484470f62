#pragma once
#include <map>
#include <string>

#include "solitaire/run/evaluator.h"

namespace solitaire {

/// The program of a text. Throws ProgramError.
Program sampled_program(const std::string& text);

/// How probable each value is that a program returns, as text: by running every execution, each weighted by
/// the densities of its choices, its factors and its wishes. For programs whose choices are finite.
std::map<std::string, double> exact_probabilities(const Program& program);

}  // namespace solitaire
