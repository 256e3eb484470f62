#pragma once
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/source.h"
#include "base/span.h"

namespace solitaire {

/// Says how much a diagnostic matters. A program with an error cannot be run; a warning points at what is
/// allowed and hardly meant; a note tells what may be good to know.
enum class Severity : std::uint8_t { kError, kWarning, kNote };

/// A further place that a diagnostic speaks of, such as where the other definition stands.
struct RelatedPlace {
  Span span;
  std::string message;
};

/// Something to tell the author about a place in the program.
struct Diagnostic {
  Span span;
  std::string message;             // what is wrong
  std::string help;                // what to do about it, or ""
  std::vector<std::string> notes;  // for example the calls that led here
  Severity severity = Severity::kError;
  /// Names the kind of the diagnostic for tools, such as "unknown-name"; it stays the same when messages are
  /// reworded. Empty for what is found while the program runs.
  std::string code = "";
  std::vector<RelatedPlace> related = {};
};

/// Returns the diagnostic as text:
///
///     file.sol:3:10: error: there is no 'widht'
///       3 |     return Obj("table", widht, height);
///         |                         ^^^^^
///       help: did you mean 'width'?
std::string format(const Diagnostic& diagnostic, const SourceSet& sources);
/// Returns the text with another word in the place of "error".
std::string format(const Diagnostic& diagnostic, const SourceSet& sources, const std::string& word);

/// Errors in a program: one, or several where reporting them together is safe.
class ProgramError : public std::runtime_error {
 public:
  explicit ProgramError(std::vector<Diagnostic> diagnostics);
  explicit ProgramError(Diagnostic diagnostic) : ProgramError(std::vector{std::move(diagnostic)}) {}

  const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }

 private:
  std::vector<Diagnostic> diagnostics_;
};

/// Collects diagnostics while the work goes on. Further ones than kMost are dropped, as they would help
/// nobody.
class Diagnostics {
 public:
  static constexpr std::size_t kMost = 100;

  void add(Diagnostic diagnostic);
  /// Adds an error.
  void add(const std::string& code, Span span, std::string message, std::string help = "");
  bool empty() const { return list_.empty(); }
  bool is_full() const { return list_.size() >= kMost; }
  const std::vector<Diagnostic>& list() const { return list_; }
  /// Returns all of them in the order of the sources.
  std::vector<Diagnostic> sorted() const;

 private:
  std::vector<Diagnostic> list_;
};

}  // namespace solitaire
