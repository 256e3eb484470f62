#pragma once
#include "base/diagnostic.h"
#include "solitaire/syntax/syntax.h"

namespace solitaire {

/// Reads one source. Mistakes are reported and read over, so that a tree comes out in any case; what could
/// not be read stands in it as ErrorExpr and ErrorStmt.
SyntaxTree parse(const SourceSet& sources, std::uint32_t source, Diagnostics& diagnostics);

/// Reads a source that is a single expression, such as the value of a command line's --set.
ExprPtr parse_expression(const SourceSet& sources, std::uint32_t source, Diagnostics& diagnostics);

}  // namespace solitaire
