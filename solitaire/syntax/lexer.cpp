#include "solitaire/syntax/lexer.h"

#include <array>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <utility>

#include "tracegraph/interval.h"

namespace solitaire {
namespace {

/// A spelling of other languages: what to write instead, and the token that it is read as.
struct Foreign {
  std::string_view spelling;
  std::string_view help;
  TokenKind kind;
};
constexpr std::array kForeign = {
    Foreign{"&&", "write 'and'", TokenKind::kAnd},
    Foreign{"||", "write 'or'", TokenKind::kOr},
    Foreign{"!", "write 'not'", TokenKind::kNot},
    Foreign{"'", "strings stand in double quotes", TokenKind::kString},
    Foreign{"#", "comments start with //", TokenKind::kEnd},
};

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_name_start(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_name_part(char c) { return is_name_start(c) || is_digit(c); }

/// Returns true if a text starts with the byte order mark of UTF-16, or with two characters of ASCII in
/// UTF-16, which are bytes of which every other one is zero.
bool is_utf16(std::string_view text) {
  const std::string_view start = text.substr(0, 4);
  if (start.substr(0, 2) == "\xFF\xFE" || start.substr(0, 2) == "\xFE\xFF") return true;
  if (start.size() < 4) return false;
  const auto zeros = [&](std::size_t first) { return start[first] == '\0' && start[first + 2] == '\0'; };
  return zeros(0) != zeros(1);
}

/// Names are repeated in messages and addresses, and compared with each other.
constexpr std::size_t kLongestName = 1000;

class Lexer {
 public:
  Lexer(std::string_view text, std::uint32_t source, Diagnostics& diagnostics)
      : text_(text), source_(source), diagnostics_(diagnostics) {
    result_.tokens.reserve(text.size() / 3);  // more than scripts have, and what is not used costs nothing
  }

  TokenList run() {
    if (text_.substr(0, 3) == "\xEF\xBB\xBF") at_ = 3;
    if (is_utf16(text_)) {
      diagnostics_.add("not-utf8", span(), "this file is UTF-16, and a script is UTF-8", "save it as UTF-8");
      at_ = text_.size();
    }
    require_utf8();
    while (skip_blank()) {
      start_ = at_;
      read_token();
    }
    start_ = at_;
    push(TokenKind::kEnd);
    return std::move(result_);
  }

 private:
  /// Reports the first byte that is no UTF-8. The text is read all the same, for what else may be wrong.
  void require_utf8() {
    start_ = find_broken_utf8(text_);
    if (at_ == text_.size() || start_ == text_.size()) return;
    const Span byte{source_, static_cast<std::uint32_t>(start_), static_cast<std::uint32_t>(start_ + 1)};
    diagnostics_.add("not-utf8", byte,
                     fmt::format("this file is not UTF-8: it has the byte \\x{:02x} here",
                                 static_cast<unsigned char>(text_[start_])),
                     "save it as UTF-8");
  }

  char peek(std::size_t ahead = 0) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }
  bool starts_with(std::string_view prefix) const {
    return peek() == prefix.front() && text_.substr(at_, prefix.size()) == prefix;
  }
  Span span() const { return {source_, static_cast<std::uint32_t>(start_), static_cast<std::uint32_t>(at_)}; }

  Token& push(TokenKind kind) {
    result_.tokens.push_back({kind, span(), 0, 0, ""});
    return result_.tokens.back();
  }

  /// Goes to the next token and keeps the comments on the way. Returns false at the end of the text.
  bool skip_blank() {
    while (at_ < text_.size()) {
      if (starts_with("//")) {
        start_ = at_;
        at_ = std::min(text_.find('\n', at_), text_.size());
        result_.comments.push_back(span());
      } else if (starts_with("/*")) {
        start_ = at_;
        const std::size_t close = text_.find("*/", at_ + 2);
        if (close == std::string_view::npos) {
          at_ += 2;
          diagnostics_.add("unclosed-comment", span(), "this comment has no end", "close it with */");
          at_ = text_.size();
        } else {
          at_ = close + 2;
        }
        result_.comments.push_back(span());
      } else if (peek() == ' ' || peek() == '\t' || peek() == '\n' || peek() == '\r') {
        ++at_;
      } else {
        return true;
      }
    }
    return false;
  }

  void read_token() {
    if (is_name_start(peek())) return read_name();
    if (is_digit(peek())) return read_number();
    if (peek() == '"') return read_string();
    const auto punctuation = find_punctuation(text_.substr(at_));
    if (!punctuation) return read_foreign();
    at_ += punctuation->length;
    push(punctuation->kind);
  }

  void read_foreign() {
    for (const auto& [spelling, help, kind] : kForeign) {
      if (!starts_with(spelling)) continue;
      at_ += spelling.size();
      diagnostics_.add("foreign-syntax", span(), fmt::format("'{}' is not used in this language", spelling),
                       std::string(help));
      return read_as(kind);
    }
    do ++at_;
    while ((static_cast<unsigned char>(peek()) & 0xC0U) == 0x80U);
    if (text_[start_] == '?')
      return diagnostics_.add("foreign-syntax", span(), "'?' is not used in this language",
                              "one of two values is written: if c then a else b");
    const unsigned char first = static_cast<unsigned char>(text_[start_]);
    const std::string shown = first < 0x20 || first == 0x7F ? fmt::format("\\x{:02x}", first)
                                                            : std::string(text_.substr(start_, at_ - start_));
    diagnostics_.add("unexpected-character", span(), fmt::format("unexpected character '{}'", shown));
  }

  /// Reads on as what a foreign token stands for, so that nothing more is reported about it.
  void read_as(TokenKind kind) {
    if (kind == TokenKind::kEnd) {  // a comment, up to the end of the line
      at_ = std::min(text_.find('\n', at_), text_.size());
      return;
    }
    if (kind == TokenKind::kString) {
      at_ = std::min(text_.find_first_of("'\n", at_), text_.size());
      if (peek() == '\'') ++at_;
    }
    push(kind);
  }

  void read_name() {
    while (is_name_part(peek())) ++at_;
    std::string_view name = text_.substr(start_, at_ - start_);
    if (name.size() > kLongestName) {
      diagnostics_.add("long-name", span(), fmt::format("this name has {} letters", name.size()),
                       fmt::format("a name has at most {}", kLongestName));
      name = name.substr(0, kLongestName);
    }
    if (const auto keyword = find_keyword(name)) {
      push(*keyword);
    } else {
      push(TokenKind::kName).text = std::string(name);
    }
  }

  void skip_digits() {
    while (is_digit(peek())) ++at_;
  }

  void read_number() {
    skip_digits();
    bool is_float = false;
    if (peek() == '.' && is_digit(peek(1))) {  // not the dots of 0..3
      is_float = true;
      ++at_;
      skip_digits();
    }
    const std::size_t sign = peek(1) == '+' || peek(1) == '-' ? 1 : 0;
    if ((peek() == 'e' || peek() == 'E') && is_digit(peek(1 + sign))) {
      is_float = true;
      at_ += 1 + sign;
      skip_digits();
    }
    if (is_name_start(peek())) {
      while (is_name_part(peek())) ++at_;
      diagnostics_.add("bad-number", span(), "a number runs into a name", number_help());
    }
    is_float ? push_float() : push_int();
  }

  std::string number_help() const {
    const std::string_view text = text_.substr(start_, at_ - start_);
    if (text.size() > 1 && text[0] == '0' &&
        std::string_view("xXbBoO").find(text[1]) != std::string_view::npos)
      return "ints are written in decimal: 16, not 0x10";
    if (text.find('_') != std::string_view::npos) return "digits are not grouped: write 1000";
    return "put a space or an operator between them";
  }

  void push_float() {
    double value = 0;
    const auto [end, error] = std::from_chars(text_.data() + start_, text_.data() + at_, value);
    if (error != std::errc{} || !std::isfinite(value))
      diagnostics_.add("bad-number", span(), "this number is too large or too small for a float");
    push(TokenKind::kFloat).float_value = value;
  }

  void push_int() {
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(text_.data() + start_, text_.data() + at_, value);
    if (error == std::errc::result_out_of_range || !is_exact(value)) {
      diagnostics_.add("bad-number", span(), "this int is past 62 bits",
                       "ints lie between -(2^62 - 1) and 2^62 - 1");
      value = 0;
    }
    push(TokenKind::kInt).int_value = value;
  }

  void read_string() {
    std::string contents;
    ++at_;
    while (peek() != '"') {
      if (at_ >= text_.size() || peek() == '\n') {
        diagnostics_.add("unclosed-string", span(), "this string has no end",
                         "close it with \" on the same line");
        push(TokenKind::kString).text = std::move(contents);
        return;
      }
      if (peek() == '\\') {
        read_escape(contents);
      } else {
        contents += text_[at_++];
      }
    }
    ++at_;
    push(TokenKind::kString).text = std::move(contents);
  }

  void read_escape(std::string& contents) {
    constexpr std::array<std::pair<char, char>, 4> kEscapes = {
        {{'n', '\n'}, {'t', '\t'}, {'"', '"'}, {'\\', '\\'}}};
    for (const auto& [letter, character] : kEscapes) {
      if (peek(1) == letter) {
        contents += character;
        at_ += 2;
        return;
      }
    }
    const Span escape{source_, static_cast<std::uint32_t>(at_),
                      static_cast<std::uint32_t>(std::min(at_ + 2, text_.size()))};
    diagnostics_.add("unknown-escape", escape, "unknown escape in a string",
                     "there are \\n, \\t, \\\" and \\\\");
    ++at_;
  }

  std::string_view text_;
  std::uint32_t source_;
  Diagnostics& diagnostics_;
  std::size_t at_ = 0;
  std::size_t start_ = 0;
  TokenList result_;
};

}  // namespace

TokenList tokenize(const SourceSet& sources, std::uint32_t source, Diagnostics& diagnostics) {
  return Lexer(sources[source].text(), source, diagnostics).run();
}

}  // namespace solitaire
