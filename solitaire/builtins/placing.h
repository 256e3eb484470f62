#pragma once
#include "solitaire/builtins/builtin.h"
#include "solitaire/run/execution.h"

namespace solitaire {

/// What a call of place() puts where: all of a placement that its arguments say. Where they depend on
/// choices, all that they can be is checked, and what is returned is of no use. Throws as a builtin's call.
Placement read_placement(Evaluator& evaluator, const BuiltinCall& call);

}  // namespace solitaire
