#pragma once
#include <string>

namespace solitaire::tiles {

/// Returns a JSON text in which comments, and commas behind the last member of a list or an object, are
/// blanks, so that every line and column stays where it was. Many programs accept both, and so do the people
/// who write files for them.
std::string strict_json(std::string text);

}  // namespace solitaire::tiles
