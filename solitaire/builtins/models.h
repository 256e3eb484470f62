#pragma once
#include "solitaire/builtins/builtin.h"
#include "solitaire/value/value.h"

namespace solitaire {

/// The builtins that ask about models.
Value size_of(Evaluator& evaluator, const BuiltinCall& call);
Value has_front(Evaluator& evaluator, const BuiltinCall& call);

}  // namespace solitaire
