#pragma once
#include "base/diagnostic.h"
#include "solitaire/syntax/syntax.h"

namespace solitaire {

/// Adds warnings about what is allowed and hardly meant: statements that are never reached, and functions and
/// records that replace another one of their name in the same block.
void add_warnings(const SyntaxTree& tree, Diagnostics& diagnostics);

}  // namespace solitaire
