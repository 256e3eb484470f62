#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/span.h"

namespace solitaire {

enum class TokenKind : std::uint8_t {
  kEnd,
  kInt,
  kFloat,
  kString,
  kName,
  // keywords
  kAnd,
  kBreak,
  kContinue,
  kElse,
  kFalseWord,
  kFor,
  kFun,
  kIf,
  kImport,
  kIn,
  kNil,
  kNot,
  kOr,
  kParam,
  kRecord,
  kReturn,
  kThen,
  kTrueWord,
  kWhile,
  // punctuation
  kLeftParen,
  kRightParen,
  kLeftBracket,
  kRightBracket,
  kLeftBrace,
  kRightBrace,
  kComma,
  kSemicolon,
  kColon,
  kDot,
  kDotDot,
  kAssign,
  kPlusAssign,
  kMinusAssign,
  kStarAssign,
  kSlashAssign,
  kPercentAssign,
  kEqual,
  kNotEqual,
  kLess,
  kLessEqual,
  kGreater,
  kGreaterEqual,
  kPlus,
  kMinus,
  kStar,
  kSlash,
  kPercent,
};

struct Token {
  TokenKind kind = TokenKind::kEnd;
  Span span;
  std::int64_t int_value = 0;
  double float_value = 0;
  std::string text;  // a name, or the contents of a string with escapes resolved
};

/// Returns the keyword of that spelling, or nothing if it is a name.
std::optional<TokenKind> find_keyword(std::string_view spelling);

/// An operator or bracket at the start of a text.
struct Punctuation {
  TokenKind kind;
  std::size_t length;
};

/// Returns the longest operator or bracket that the text starts with.
std::optional<Punctuation> find_punctuation(std::string_view text);

/// Returns how messages call a token: "';'", "a name", "the end of the file".
std::string describe(TokenKind kind);

}  // namespace solitaire
