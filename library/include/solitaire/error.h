#pragma once
#include <cstddef>
#include <cstdint>
#include <solitaire/export.h>
#include <stdexcept>
#include <string>
#include <vector>

namespace solitaire::api {

/// Says how much a diagnostic matters. A program with an error cannot be run; a warning points at what is
/// allowed and hardly meant.
enum class Severity : std::uint8_t { kError, kWarning, kNote };

/// A further place that a diagnostic speaks of, such as where the other definition stands.
struct RelatedPlace {
  std::string file;
  std::size_t line = 1, column = 1;
  std::string message;
};

/// Something to tell the author about a place in a program.
struct Diagnostic {
  std::string file;                          // as messages call it
  std::size_t line = 1, column = 1;          // where it begins; both count from 1, columns in characters
  std::size_t end_line = 1, end_column = 1;  // just behind its last character
  std::string message;                       // what is wrong
  std::string help;                          // what to do about it, or ""
  std::vector<std::string> notes;            // such as the calls that led here
  std::string text;  // all of this on several lines, with the line of the program and a caret
  std::string code;  // the kind of error, such as "unknown-name"; "" for what is found by running
  Severity severity = Severity::kError;
  std::vector<RelatedPlace> related;
};

/// Every error of this library, except std::bad_alloc where there is no more memory.
class SOLITAIRE_API Error : public std::runtime_error {
 public:
  enum class Kind : std::uint8_t {
    kProgram,   // the program is wrong: diagnostics() says where
    kUsage,     // an option, a param or a pin is wrong
    kFile,      // a file cannot be read or written
    kStopped,   // a stop was asked for before the work was done
    kInternal,  // a fault of Solitaire; please report it with the script
  };

  Error(Kind kind, const std::string& message, std::vector<Diagnostic> diagnostics = {});
  ~Error() override;

  Kind kind() const { return kind_; }
  /// Returns the places in a text that the error is about. Where there are any, what() holds their texts.
  const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }

 private:
  Kind kind_;
  std::vector<Diagnostic> diagnostics_;
};

}  // namespace solitaire::api
