#pragma once
#include <string>

#include "base/diagnostic.h"
#include "solitaire/syntax/parser.h"

namespace solitaire {

/// Parses a text and says what is wrong with the tree that comes out: spans that lie outside the text or
/// outside what is around them, missing parts, an error in the tree that nobody was told of. "" if nothing
/// is.
std::string tree_fault(const std::string& text);

}  // namespace solitaire
