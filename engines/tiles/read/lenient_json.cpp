#include "engines/tiles/read/lenient_json.h"

#include <algorithm>

namespace solitaire::tiles {
namespace {

void blank(std::string& text, std::size_t from, std::size_t to) {
  for (std::size_t at = from; at < to; ++at) {
    if (text[at] != '\n') text[at] = ' ';
  }
}

/// Returns where the string that begins at a quote ends.
std::size_t end_of_string(const std::string& text, std::size_t quote) {
  std::size_t at = quote + 1;
  while (at < text.size() && text[at] != '"') at += text[at] == '\\' ? 2 : 1;
  return std::min(at + 1, text.size());
}

/// Returns where a comment ends that begins there; the same place if none does.
std::size_t end_of_comment(const std::string& text, std::size_t at) {
  if (text.compare(at, 2, "//") == 0) return std::min(text.find('\n', at), text.size());
  if (text.compare(at, 2, "/*") != 0) return at;
  const std::size_t end = text.find("*/", at + 2);
  return end == std::string::npos ? text.size() : end + 2;
}

}  // namespace

std::string strict_json(std::string text) {
  std::size_t comma = std::string::npos;  // the last one, if only blanks follow it so far
  for (std::size_t at = 0; at < text.size();) {
    if (const std::size_t end = end_of_comment(text, at); end > at) {
      blank(text, at, end);
      at = end;
      continue;
    }
    const char letter = text[at];
    if ((letter == ']' || letter == '}') && comma != std::string::npos) text[comma] = ' ';
    if (letter != ' ' && letter != '\t' && letter != '\n' && letter != '\r')
      comma = letter == ',' ? at : std::string::npos;
    at = letter == '"' ? end_of_string(text, at) : at + 1;
  }
  return text;
}

}  // namespace solitaire::tiles
