#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "base/source.h"
#include "solitaire/syntax/lexer.h"
#include "solitaire/syntax/token.h"

namespace solitaire {

/// The tokens of one source, read from the front, and what happens after a syntax error.
///
/// The first error of a statement makes the reader panic. From then on every token reads as the end of the
/// file and nothing more is reported, so that all productions of the grammar end at once with the nodes that
/// they have so far. The panic ends where reading makes sense again: at the next statement, or at the '{' of
/// a block whose head could not be read.
class TokenReader {
 public:
  TokenReader(const SourceSet& sources, std::uint32_t source, Diagnostics& diagnostics);

 protected:
  /// Statements and expressions nest no deeper than this in the source.
  static constexpr int kDeepestNesting = 256;

  /// Counts nesting while it lives. Nesting that is too deep is an error.
  class Nesting {
   public:
    explicit Nesting(TokenReader& reader);
    ~Nesting() { --reader_.nesting_; }
    Nesting(const Nesting&) = delete;
    Nesting& operator=(const Nesting&) = delete;

   private:
    TokenReader& reader_;
  };

  // ---- tokens

  const Token& peek(std::size_t ahead = 0) const;
  bool at(TokenKind kind) const { return peek().kind == kind; }
  const Token& take();
  bool accept(TokenKind kind);
  /// Takes a token of that kind; it is an error if there is none here. `where` continues the sentence
  /// "expected ';'".
  const Token& expect(TokenKind kind, const std::string& where, const std::string& help = "");
  /// Returns what to write where an `if` stands behind a value, as other languages have it; else "".
  std::string help_for_if() const;
  /// Returns the token that was taken last.
  const Token& previous() const { return list_.tokens[at_ == 0 ? 0 : at_ - 1]; }
  /// Nothing is said of a name that stands for something else, as a keyword of another language does.
  void distrust_name(const Token& name) { skipped_names_.push_back(name.text); }
  const Token& statement_start() const { return list_.tokens[statement_start_]; }
  /// Returns true if the next token stands on a later line than the previous one.
  bool on_new_line() const { return starts_line(at_); }

  /// Ends a node behind the token that was taken last.
  template <class Node>
  std::unique_ptr<Node> finish(std::unique_ptr<Node> node) const {
    node->span.end = std::max(node->span.begin, previous().span.end);
    return node;
  }

  // ---- errors

  bool panicking() const { return panicking_; }
  /// Reports an error and reads on; in a panic it reports nothing.
  void report(Diagnostic diagnostic);
  void report(const std::string& code, Span span, std::string message, std::string help = "");
  /// Reports a syntax error at the next token and panics.
  void fail(std::string message, std::string help = "");
  /// Returns true at the end of the file, where it reports that `bracket`, opened at `open`, is never closed.
  bool never_closed(Span open, const std::string& bracket);

  // ---- recovery

  /// Starts a statement; returns what end_statement needs.
  std::size_t begin_statement();
  /// Ends a statement. In a panic it skips to where the next statement starts, and ends the panic.
  void end_statement(std::size_t outer);
  /// In a panic, skips to a '{' that stands before the end of the statement, and ends the panic there.
  void recover_at_block();

  /// In a panic, treats the names that were read from `start` on like skipped ones: what would define them
  /// could not be read.
  void distrust_names(Span start);

  TokenList take_tokens() { return std::move(list_); }
  /// Returns the names in the stretches of text that were skipped, which may have been defined there.
  std::vector<std::string> take_skipped_names();

 private:
  bool starts_line(std::size_t token) const;
  void panic();
  void distrust_assigned();
  void skip_to_next_statement();
  void skip();

  Diagnostics& diagnostics_;
  const SourceSet& sources_;
  TokenList list_;
  Token end_;  // what every token reads as in a panic
  std::size_t at_ = 0;
  std::size_t statement_start_ = 0;
  int nesting_ = 0;
  bool panicking_ = false;
  std::size_t distrusted_ = 0;  // in a panic, the names from this token on are distrusted already
  std::vector<std::string> skipped_names_;
};

}  // namespace solitaire
