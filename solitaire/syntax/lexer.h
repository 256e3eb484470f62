#pragma once
#include <string>
#include <vector>

#include "base/diagnostic.h"

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
  kFalse,
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
  kTrue,
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

/// The whole text as tokens, the last one kEnd, and beside them the comments with their spans.
struct TokenList {
  std::vector<Token> tokens;
  std::vector<Span> comments;
};

/// Reports what is no token and goes on behind it.
TokenList tokenize(const SourceSet& sources, std::uint32_t source, Diagnostics& diagnostics);

/// How the token is called in messages: "';'", "a name", "the end of the file".
std::string describe(TokenKind kind);

}  // namespace solitaire
