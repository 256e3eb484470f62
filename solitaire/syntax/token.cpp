#include "solitaire/syntax/token.h"

#include <array>
#include <fmt/format.h>
#include <utility>

namespace solitaire {
namespace {

using Spelling = std::pair<std::string_view, TokenKind>;

constexpr std::array kKeywords = {
    Spelling{"and", TokenKind::kAnd},
    Spelling{"break", TokenKind::kBreak},
    Spelling{"continue", TokenKind::kContinue},
    Spelling{"else", TokenKind::kElse},
    Spelling{"false", TokenKind::kFalseWord},
    Spelling{"for", TokenKind::kFor},
    Spelling{"fun", TokenKind::kFun},
    Spelling{"if", TokenKind::kIf},
    Spelling{"import", TokenKind::kImport},
    Spelling{"in", TokenKind::kIn},
    Spelling{"nil", TokenKind::kNil},
    Spelling{"not", TokenKind::kNot},
    Spelling{"or", TokenKind::kOr},
    Spelling{"param", TokenKind::kParam},
    Spelling{"record", TokenKind::kRecord},
    Spelling{"return", TokenKind::kReturn},
    Spelling{"then", TokenKind::kThen},
    Spelling{"true", TokenKind::kTrueWord},
    Spelling{"while", TokenKind::kWhile},
};

/// Longer ones stand first, so that "==" is not read as two "=".
constexpr std::array kPunctuation = {
    Spelling{"..", TokenKind::kDotDot},      Spelling{"+=", TokenKind::kPlusAssign},
    Spelling{"-=", TokenKind::kMinusAssign}, Spelling{"*=", TokenKind::kStarAssign},
    Spelling{"/=", TokenKind::kSlashAssign}, Spelling{"%=", TokenKind::kPercentAssign},
    Spelling{"==", TokenKind::kEqual},       Spelling{"!=", TokenKind::kNotEqual},
    Spelling{"<=", TokenKind::kLessEqual},   Spelling{">=", TokenKind::kGreaterEqual},
    Spelling{"(", TokenKind::kLeftParen},    Spelling{")", TokenKind::kRightParen},
    Spelling{"[", TokenKind::kLeftBracket},  Spelling{"]", TokenKind::kRightBracket},
    Spelling{"{", TokenKind::kLeftBrace},    Spelling{"}", TokenKind::kRightBrace},
    Spelling{",", TokenKind::kComma},        Spelling{";", TokenKind::kSemicolon},
    Spelling{":", TokenKind::kColon},        Spelling{".", TokenKind::kDot},
    Spelling{"=", TokenKind::kAssign},       Spelling{"<", TokenKind::kLess},
    Spelling{">", TokenKind::kGreater},      Spelling{"+", TokenKind::kPlus},
    Spelling{"-", TokenKind::kMinus},        Spelling{"*", TokenKind::kStar},
    Spelling{"/", TokenKind::kSlash},        Spelling{"%", TokenKind::kPercent},
};

}  // namespace

std::optional<TokenKind> find_keyword(std::string_view spelling) {
  for (const auto& [keyword, kind] : kKeywords) {
    if (spelling.front() == keyword.front() && spelling == keyword) return kind;
  }
  return std::nullopt;
}

std::optional<Punctuation> find_punctuation(std::string_view text) {
  for (const auto& [spelling, kind] : kPunctuation) {
    if (text.front() == spelling.front() && text.substr(0, spelling.size()) == spelling)
      return Punctuation{kind, spelling.size()};
  }
  return std::nullopt;
}

std::string describe(TokenKind kind) {
  switch (kind) {
    case TokenKind::kEnd:
      return "the end of the file";
    case TokenKind::kInt:
    case TokenKind::kFloat:
      return "a number";
    case TokenKind::kString:
      return "a string";
    case TokenKind::kName:
      return "a name";
    default:
      break;
  }
  for (const auto& [spelling, keyword] : kKeywords) {
    if (keyword == kind) return fmt::format("'{}'", spelling);
  }
  for (const auto& [spelling, punctuation] : kPunctuation) {
    if (punctuation == kind) return fmt::format("'{}'", spelling);
  }
  return "a token";
}

}  // namespace solitaire
