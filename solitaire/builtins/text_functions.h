#pragma once
#include "solitaire/builtins/builtin.h"
#include "solitaire/value/value.h"

// The builtins that make text of values.

namespace solitaire {

/// str: the texts of all arguments, joined.
Value text_of_values(Evaluator& evaluator, const BuiltinCall& call);
/// format: a text in which values stand in place of its fields.
Value format_text(Evaluator& evaluator, const BuiltinCall& call);

}  // namespace solitaire
