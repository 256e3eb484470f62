#pragma once
#include "engines/solve/executions/execution_solver.h"
#include "engines/solve/pins/pins.h"

namespace solitaire {

/// Checks that every pin matches a choice of the program, and that no choice is pinned to a value of another
/// type. A choice that no execution meets, since another pin or an assert keeps executions from it, is one of
/// the program: its pin plays no part. For pins of choices on paths that are not explored yet, some more
/// passes are run. Throws UnmatchedPin and Interrupted.
void check_pins(Pins& pins, ExecutionSolver& solver, const Program& program, const ParamValues& params,
                const TracingOptions& options);

}  // namespace solitaire
