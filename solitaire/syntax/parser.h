#pragma once
#include <cstdint>

#include "base/diagnostic.h"
#include "base/source.h"
#include "solitaire/syntax/syntax.h"

namespace solitaire {

/// Reads one source. Errors are reported and read over, so that a tree comes out in any case. A statement
/// with an error keeps what was read of it, with an ErrorExpr or ErrorStmt in the place of what is missing.
SyntaxTree parse(const SourceSet& sources, std::uint32_t source, Diagnostics& diagnostics);

/// Reads a source that is a single expression, such as the value of a command line's --set.
ExprPtr parse_expression(const SourceSet& sources, std::uint32_t source, Diagnostics& diagnostics);

}  // namespace solitaire
