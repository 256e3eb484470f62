#pragma once
#include <string>

#include "tests/generator/draft.h"
#include "tests/generator/source_text.h"
#include "tests/generator/statements.h"

namespace solitaire::generator {

/// Writes one file of a program.
class FileWriter {
 public:
  FileWriter(ByteSource& bytes, std::string letter) : draft_(bytes, std::move(letter)) {}
  FileWriter(const FileWriter&) = delete;
  FileWriter& operator=(const FileWriter&) = delete;

  /// Imports another file: its own top-level names can be used from now on. What it imports itself is not
  /// passed on.
  void import(const FileWriter& other);
  /// Writes the script, with wishes if it should have some.
  void write_script(bool wishes);
  /// Writes a file that is imported. It has no `return`.
  void write_part();

  SourceText file() const;

 private:
  /// Makes a choice, so that there is something that later statements can depend on.
  void first_choice();
  /// Imports a file of the library, such as "graph".
  void import_library(const std::string& name);
  void output();
  /// Makes a name that several files have: each file sees its own, or that of the last import.
  void shared_name();
  void param();

  Draft draft_;
  Statements statements_{draft_};
  std::ptrdiff_t imported_variables_ = 0;  // the first ones of the draft's variables
  std::ptrdiff_t imported_functions_ = 0;  // and of its functions
};

}  // namespace solitaire::generator
