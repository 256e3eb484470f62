#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "engines/solve/executions/traced_program.h"
#include "tracegraph/valuation.h"

namespace solitaire {

/// Returns the choices of all solutions of a program in a random order, each as probable as the others, or
/// nothing if there are more than `most`, or if they cannot be gone through one after the other. It is only
/// tried where there are few combinations of values at all, so that it takes milliseconds.
///
/// Where most solutions have been found already, a search from random values finds the same ones again and
/// again, and has to be told of each.
std::optional<std::vector<Valuation>> few_solutions(TracedProgram& traced, std::size_t most,
                                                    std::uint64_t seed);

}  // namespace solitaire
