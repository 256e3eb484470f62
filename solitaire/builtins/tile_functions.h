#pragma once
#include "solitaire/builtins/builtin.h"
#include "solitaire/value/value.h"

namespace solitaire {

/// The builtins for what may be beside what.
Value allowed(Evaluator& evaluator, const BuiltinCall& call);
Value tile_pairs(Evaluator& evaluator, const BuiltinCall& call);
Value tile_neighbors(Evaluator& evaluator, const BuiltinCall& call);
Value tile_sites(Evaluator& evaluator, const BuiltinCall& call);

}  // namespace solitaire
