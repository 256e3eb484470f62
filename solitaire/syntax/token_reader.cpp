#include "solitaire/syntax/token_reader.h"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

namespace solitaire {
namespace {

bool starts_statement(TokenKind kind) {
  switch (kind) {
    case TokenKind::kBreak:
    case TokenKind::kContinue:
    case TokenKind::kFor:
    case TokenKind::kImport:
    case TokenKind::kParam:
    case TokenKind::kRecord:
    case TokenKind::kReturn:
    case TokenKind::kWhile:
      return true;
    default:
      return false;
  }
}

}  // namespace

TokenReader::TokenReader(const SourceSet& sources, std::uint32_t source, Diagnostics& diagnostics)
    : diagnostics_(diagnostics), sources_(sources), list_(tokenize(sources, source, diagnostics)) {}

TokenReader::Nesting::Nesting(TokenReader& reader) : reader_(reader) {
  if (++reader_.nesting_ > kDeepestNesting)
    reader_.fail("this nests too deeply", "move an inner part into a function of its own");
}

// ---- tokens

const Token& TokenReader::peek(std::size_t ahead) const {
  if (panicking_) return end_;
  return list_.tokens[std::min(at_ + ahead, list_.tokens.size() - 1)];
}

const Token& TokenReader::take() {
  const Token& token = peek();
  if (!panicking_) skip();
  return token;
}

bool TokenReader::accept(TokenKind kind) {
  if (!at(kind)) return false;
  take();
  return true;
}

const Token& TokenReader::expect(TokenKind kind, const std::string& where, const std::string& help) {
  if (!at(kind)) {
    fail(fmt::format("expected {} {}, found {}", describe(kind), where, describe(peek().kind)),
         help.empty() ? help_for_if() : help);
    return peek();
  }
  return take();
}

std::string TokenReader::help_for_if() const {
  return at(TokenKind::kIf) ? "one of two values is written: if c then a else b" : "";
}

bool TokenReader::starts_line(std::size_t token) const {
  if (token == 0) return true;
  const Span before = list_.tokens[token - 1].span;
  const Source& source = sources_[before.source];
  return source.position(before.end).line < source.position(list_.tokens[token].span.begin).line;
}

// ---- errors

void TokenReader::report(Diagnostic diagnostic) {
  if (!panicking_) diagnostics_.add(std::move(diagnostic));
}

void TokenReader::report(const std::string& code, Span span, std::string message, std::string help) {
  if (!panicking_) diagnostics_.add(code, span, std::move(message), std::move(help));
}

void TokenReader::fail(std::string message, std::string help) {
  report("syntax", peek().span, std::move(message), std::move(help));
  panic();
}

bool TokenReader::never_closed(Span open, const std::string& bracket) {
  if (!at(TokenKind::kEnd)) return false;
  report("unclosed-bracket", open, fmt::format("this '{}' is never closed", bracket));
  panic();
  return true;
}

/// Nodes that are made in a panic are empty and stand behind the last token that was read.
void TokenReader::panic() {
  if (panicking_) return;
  const Span last = previous().span;
  const std::uint32_t point = at_ == 0 ? last.begin : last.end;
  end_.kind = TokenKind::kEnd;
  end_.span = {last.source, point, point};
  panicking_ = true;
  distrusted_ = at_;
  distrust_assigned();
}

/// Where a line is not finished, the next one is read as its end: of `x = f(` and, below it, `y = 1;`, the
/// `y` is an argument. So a name before the '=' that cannot be read is treated like a skipped one.
void TokenReader::distrust_assigned() {
  const bool is_assigned = at_ > 0 && list_.tokens[at_].kind == TokenKind::kAssign;
  if (is_assigned && previous().kind == TokenKind::kName && starts_line(at_ - 1))
    skipped_names_.push_back(previous().text);
}

// ---- recovery

std::size_t TokenReader::begin_statement() { return std::exchange(statement_start_, at_); }

void TokenReader::end_statement(std::size_t outer) {
  if (panicking_) skip_to_next_statement();
  statement_start_ = outer;
}

/// Goes on by a token and remembers it if it is a name that recovery skips.
void TokenReader::skip() {
  if (panicking_ && list_.tokens[at_].kind == TokenKind::kName)
    skipped_names_.push_back(list_.tokens[at_].text);
  if (at_ + 1 < list_.tokens.size()) ++at_;
}

/// Skips to behind the next ';' or to where a '}' or a statement's keyword stands, over whole pairs of
/// braces. Goes on by a token at least, except before a '}'.
void TokenReader::skip_to_next_statement() {
  int open = 0;
  for (; list_.tokens[at_].kind != TokenKind::kEnd; skip()) {
    const TokenKind kind = list_.tokens[at_].kind;
    if (kind == TokenKind::kLeftBrace) ++open;
    if (kind == TokenKind::kRightBrace && --open < 0) break;
    if (open > 0) continue;
    const bool may_be_in_list = kind == TokenKind::kFor && !starts_line(at_);
    if (at_ > statement_start_ && starts_statement(kind) && !may_be_in_list) break;
    if (kind == TokenKind::kSemicolon || (kind == TokenKind::kRightBrace && open == 0)) {
      skip();
      break;
    }
  }
  panicking_ = false;
}

void TokenReader::recover_at_block() {
  if (!panicking_ || nesting_ >= kDeepestNesting) return;
  for (std::size_t ahead = at_; ahead < list_.tokens.size(); ++ahead) {
    const TokenKind kind = list_.tokens[ahead].kind;
    if (kind == TokenKind::kSemicolon || kind == TokenKind::kRightBrace || starts_statement(kind)) return;
    if (kind != TokenKind::kLeftBrace) continue;
    while (at_ < ahead) skip();
    panicking_ = false;
    return;
  }
}

void TokenReader::distrust_names(Span start) {
  if (!panicking_) return;
  for (; distrusted_ > 0 && list_.tokens[distrusted_ - 1].span.begin >= start.begin; --distrusted_) {
    const Token& token = list_.tokens[distrusted_ - 1];
    if (token.kind == TokenKind::kName) skipped_names_.push_back(token.text);
  }
}

std::vector<std::string> TokenReader::take_skipped_names() {
  std::sort(skipped_names_.begin(), skipped_names_.end());
  skipped_names_.erase(std::unique(skipped_names_.begin(), skipped_names_.end()), skipped_names_.end());
  return std::move(skipped_names_);
}

}  // namespace solitaire
