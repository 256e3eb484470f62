#pragma once
#include <cstdint>
#include <vector>

#include "base/diagnostic.h"
#include "base/source.h"
#include "solitaire/syntax/token.h"

namespace solitaire {

/// A whole text as tokens, the last one kEnd, and its comments.
struct TokenList {
  std::vector<Token> tokens;
  std::vector<Span> comments;
};

/// Splits a source into tokens. What is no token is reported and skipped. A text that is UTF-16 is reported
/// once and gives no tokens.
TokenList tokenize(const SourceSet& sources, std::uint32_t source, Diagnostics& diagnostics);

}  // namespace solitaire
