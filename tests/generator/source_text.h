#pragma once
#include <string>

namespace solitaire {

/// A file of a generated program.
struct SourceText {
  std::string name;
  std::string text;
};

}  // namespace solitaire
