#pragma once
#include <optional>

#include "engines/solution.h"
#include "solitaire/run/evaluator.h"

namespace solitaire {

/// The choices of an execution in which all asserts hold, found by a solver. Nothing where there is none, or
/// where solvers cannot look at all that the program does, as at floats that are drawn.
std::optional<ChosenValues> solved_start(const Program& program, const ParamValues& params,
                                         const Limits& limits, std::uint64_t seed);

}  // namespace solitaire
