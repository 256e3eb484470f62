#include "solitaire/syntax/parser.h"

#include "solitaire/syntax/statement_parser.h"

namespace solitaire {

SyntaxTree parse(const SourceSet& sources, std::uint32_t source, Diagnostics& diagnostics) {
  return StatementParser(sources, source, diagnostics).file();
}

ExprPtr parse_expression(const SourceSet& sources, std::uint32_t source, Diagnostics& diagnostics) {
  return StatementParser(sources, source, diagnostics).only_expression();
}

}  // namespace solitaire
