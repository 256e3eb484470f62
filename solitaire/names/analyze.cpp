#include "solitaire/names/analyze.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "base/file_error.h"
#include "solitaire/names/library_index.h"
#include "solitaire/names/resolver.h"
#include "solitaire/names/warnings.h"

namespace solitaire {
namespace {

/// A person reads no more errors than this at once.
constexpr std::size_t kMostReported = 20;

bool is_error(const Diagnostic& diagnostic) { return diagnostic.severity == Severity::kError; }

std::vector<Diagnostic> first_errors(const std::vector<Diagnostic>& diagnostics) {
  std::vector<Diagnostic> errors;
  std::copy_if(diagnostics.begin(), diagnostics.end(), std::back_inserter(errors), is_error);
  errors.resize(std::min(errors.size(), kMostReported));
  return errors;
}

}  // namespace

bool Analysis::has_errors() const { return std::any_of(diagnostics.begin(), diagnostics.end(), is_error); }

Analysis analyze(const FileProvider& files, const std::filesystem::path& script, const LoadOptions& options) {
  Analysis analysis;
  Diagnostics diagnostics;
  Program& program = analysis.program;
  program.labels.number("");  // kNoLabel
  program.models = options.models;
  program.tile_files = options.tile_files;
  const std::vector<std::uint32_t> order = load_modules(files, script, options, program, diagnostics);
  for (const std::uint32_t module : order) resolve(program, module, options.naming, diagnostics);
  for (const Module& module : program.modules) add_warnings(module.tree, diagnostics);
  analysis.diagnostics = diagnostics.sorted();
  suggest_imports(analysis.diagnostics, program.sources, files, options.library_folders);
  return analysis;
}

Program load_program(const FileProvider& files, const std::filesystem::path& script,
                     const LoadOptions& options, SourceSet& sources_on_error) {
  Analysis analysis = analyze(files, script, options);
  std::vector<Diagnostic> errors = first_errors(analysis.diagnostics);
  if (!errors.empty()) {
    if (errors.front().code == "unreadable-script") throw FileError(script.string(), errors.front().message);
    sources_on_error = std::move(analysis.program.sources);
    throw ProgramError(std::move(errors));
  }
  analysis.program.warnings = std::move(analysis.diagnostics);
  return std::move(analysis.program);
}

Program load_program(const std::filesystem::path& script, const LoadOptions& options,
                     SourceSet& sources_on_error) {
  return load_program(DiskFiles(), script, options, sources_on_error);
}

Program load_program_text(const std::string& name, std::string text, const LoadOptions& options,
                          SourceSet& sources_on_error) {
  const DiskFiles disk;
  BufferedFiles files(&disk);
  files.set(name, std::move(text));
  return load_program(files, name, options, sources_on_error);
}

}  // namespace solitaire
