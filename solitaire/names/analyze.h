#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "base/file_provider.h"
#include "base/source.h"
#include "solitaire/names/module_loader.h"
#include "solitaire/names/program.h"

namespace solitaire {

/// The result of reading a program without running it.
struct Analysis {
  /// The program, or as much of it as could be understood. It may be run only if there is no error.
  Program program;
  std::vector<Diagnostic> diagnostics;  // in the order of the sources

  bool has_errors() const;
};

/// Reads, parses and resolves a script and what it imports. It never throws for anything that stands in a
/// text, and names are looked up in spite of syntax errors, so that a language server can call it on every
/// keystroke. A script that cannot be read is an empty program with an error "unreadable-script".
Analysis analyze(const FileProvider& files, const std::filesystem::path& script, const LoadOptions& options);

/// Analyzes a script that is to be run. Throws ProgramError with the first errors if there are any, after it
/// moved the sources that they speak of to `sources_on_error`, and FileError if the script cannot be read.
Program load_program(const FileProvider& files, const std::filesystem::path& script,
                     const LoadOptions& options, SourceSet& sources_on_error);

/// Does the same for a script on the disk.
Program load_program(const std::filesystem::path& script, const LoadOptions& options,
                     SourceSet& sources_on_error);

/// Does the same for a text that stands in no file; `name` is shown in messages, and imports are looked for
/// in its folder.
Program load_program_text(const std::string& name, std::string text, const LoadOptions& options,
                          SourceSet& sources_on_error);

}  // namespace solitaire
