#pragma once
#include "solitaire/syntax/syntax.h"

namespace solitaire {

/// Returns true if an expression is free of calls and loops, so that evaluating it always ends at once.
bool is_plain(const Expr& node);

}  // namespace solitaire
