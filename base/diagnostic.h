#pragma once
#include <stdexcept>
#include <string>
#include <vector>

#include "base/source.h"

namespace solitaire {

/// Something to tell the author about a place in the program.
struct Diagnostic {
  Span span;
  std::string message;             // what is wrong
  std::string help;                // what to do about it, or ""
  std::vector<std::string> notes;  // such as the calls that led here
};

/// The diagnostic as text:
///
///     file.sol:3:10: error: there is no 'widht'
///       3 |     return Obj("table", widht, height);
///         |                         ^^^^^
///       help: did you mean 'width'?
std::string format(const Diagnostic& diagnostic, const SourceSet& sources,
                   const std::string& severity = "error");

/// Mistakes in a program: one, or several where reporting them together is safe.
class ProgramError : public std::runtime_error {
 public:
  explicit ProgramError(std::vector<Diagnostic> diagnostics);
  explicit ProgramError(Diagnostic diagnostic) : ProgramError(std::vector{std::move(diagnostic)}) {}

  const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }

 private:
  std::vector<Diagnostic> diagnostics_;
};

/// Collects diagnostics while going on, up to a number after which more would not help anybody.
class Diagnostics {
 public:
  void add(Span span, std::string message, std::string help = "");
  bool empty() const { return list_.empty(); }
  const std::vector<Diagnostic>& list() const { return list_; }
  /// Throws ProgramError, in the order of the source, if there is any diagnostic.
  void raise_if_any() const;

 private:
  std::vector<Diagnostic> list_;
};

/// The candidate that `name` was probably meant to be, or "": a few letters changed, missing or swapped.
std::string nearest_name(std::string_view name, const std::vector<std::string>& candidates);

/// At most so many of the candidates, those most alike first.
std::vector<std::string> nearest_names(std::string_view name, std::vector<std::string> candidates,
                                       std::size_t count);

}  // namespace solitaire
