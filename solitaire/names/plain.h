#pragma once
#include "solitaire/syntax/syntax.h"

namespace solitaire {

/// Returns true if an expression, whose names have been resolved, evaluates at once: it makes no choices,
/// runs no loops, and calls nothing but builtins that compute. Such sides of a branch are always looked into.
bool is_plain(const Expr& node);

/// Returns true if a statement does nothing but evaluate plain expressions, assign them and assert them, and
/// control comes to its end.
bool is_plain(const Stmt& node);

/// Returns true if an expression is plain and does nothing but compute, of whatever is computed of numbers.
bool computes(const Expr& node);

/// Returns true if a statement does nothing but weigh executions by what such expressions give.
bool weighs(const Stmt& node);

}  // namespace solitaire
