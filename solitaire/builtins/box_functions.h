#pragma once
#include "solitaire/builtins/builtin.h"
#include "solitaire/value/value.h"

namespace solitaire {

/// boxes_apart: whether no two of the boxes overlap, each a list of [low, high] for each axis.
///
/// Which pairs can overlap at all is found by a sweep along the first axis, so that n boxes of which each can
/// meet a few take time n log n and not n * n. Only those pairs become conditions.
Value boxes_apart(Evaluator& evaluator, const BuiltinCall& call);

}  // namespace solitaire
