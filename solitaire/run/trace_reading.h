#pragma once
#include <optional>

#include "solitaire/names/program.h"
#include "solitaire/run/symbolic_pass.h"
#include "tracegraph/assignment.h"

namespace solitaire {

/// Returns what `value` is in one execution; nothing where it is undefined in it, or is a text that
/// only shows when the program is run.
std::optional<Value> value_under(Assignment& assignment, const Value& value);

/// Reads what the execution with these values of the choices comes to off a pass over all executions: the
/// same as if the program was run, in a fraction of the time. Without `scene`, placements are left out.
///
/// Returns nothing where the pass does not say it: the execution leaves the explored paths, fails an assert,
/// makes a mistake, or does what only shows when it is run. The pass is one that does not go on past broken
/// asserts.
std::optional<Execution> read_execution(const Program& program, const SymbolicPass& pass,
                                        AddressTable& addresses, Assignment& assignment, bool scene);

}  // namespace solitaire
