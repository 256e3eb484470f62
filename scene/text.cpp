#include "scene/text.h"

#include <fmt/format.h>
#include <iterator>
#include <utf8.h>
#include <utf8/unchecked.h>

namespace solitaire {
namespace {

/// Calls visit(code point) for each character of the text, and U+FFFD for each broken sequence.
template <typename Visit>
void for_each_character(std::string_view text, const Visit& visit) {
  std::string valid;
  valid.reserve(text.size());
  utf8::replace_invalid(text.begin(), text.end(), std::back_inserter(valid));
  for (auto at = valid.cbegin(); at != valid.cend();) visit(utf8::unchecked::next(at));
}

/// Returns true for what XML forbids in a document or what breaks a line.
bool is_control(char32_t c) {
  const bool non_character = (c & 0xFFFE) == 0xFFFE || (c >= 0xFDD0 && c <= 0xFDEF);
  return c < 0x20 || (c >= 0x7F && c < 0xA0) || c == 0x2028 || c == 0x2029 || non_character;
}

}  // namespace

std::string clean_text(std::string_view text) {
  std::string clean;
  clean.reserve(text.size());
  for_each_character(text, [&](char32_t c) {
    utf8::unchecked::append(is_control(c) ? U' ' : c, std::back_inserter(clean));
  });
  return clean;
}

std::string escape_markup(std::string_view text) {
  std::string escaped;
  for (const char c : clean_text(text)) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\'':
        escaped += "&#39;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

std::string relative_link(std::string_view file) {
  constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-._~/";
  std::string link = "./";
  for (const char c : file) {
    if (kPlain.find(c) != std::string_view::npos) {
      link += c;
    } else {
      link += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
  }
  return link;
}

bool has_word(std::string_view text, std::string_view word) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  for (auto at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if ((at == 0 || !is_letter(text[at - 1])) && (end == text.size() || !is_letter(text[end]))) return true;
  }
  return false;
}

double text_width(std::string_view utf8) {
  // From Hangul and CJK onward a glyph may fill its square.
  double width = 0;
  for_each_character(utf8, [&](char32_t c) { width += c >= 0x1100 ? 1.05 : 0.6; });
  return width;
}

}  // namespace solitaire
