#pragma once
#include "solitaire/builtins/builtin.h"
#include "solitaire/value/value.h"

// The builtins that count, order and take parts of lists, or make lists of lists.

namespace solitaire {

Value count_equal(Evaluator& evaluator, const BuiltinCall& call);
Value index_of(Evaluator& evaluator, const BuiltinCall& call);
Value first_element(Evaluator& evaluator, const BuiltinCall& call);
Value last_element(Evaluator& evaluator, const BuiltinCall& call);
Value enumerate(Evaluator& evaluator, const BuiltinCall& call);
Value map_function(Evaluator& evaluator, const BuiltinCall& call);
Value filter_function(Evaluator& evaluator, const BuiltinCall& call);
Value sort(Evaluator& evaluator, const BuiltinCall& call);
/// min and max: of a list or of several arguments, and with `key:` by what a function makes of each.
Value minimum(Evaluator& evaluator, const BuiltinCall& call);
Value maximum(Evaluator& evaluator, const BuiltinCall& call);

}  // namespace solitaire
