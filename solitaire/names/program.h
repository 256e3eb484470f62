#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "base/file_error.h"
#include "base/name_table.h"
#include "solitaire/syntax/syntax.h"

namespace solitaire {

/// One file of a program. Its top-level names are what an import of it brings.
struct Module {
  std::filesystem::path path;
  /// The step that stands for this file in the addresses of what its top level does: "part.sol", with "#2"
  /// behind it if another file of that name came before. Its dot keeps it apart from the labels of calls.
  /// Empty for the script itself.
  std::string label;
  std::uint32_t source = 0;
  SyntaxTree tree;
  std::vector<std::uint32_t> imports;  // modules, in the order of the import statements
  std::map<std::string, Slot> names;   // of the top level
};

/// A resolved program: modules[0] is the script itself. Immutable once loaded, so that many evaluations,
/// also on several threads, can share it.
struct Program {
  SourceSet sources;
  std::vector<Module> modules;
  NameTable labels;       // the labels of all sites; the first is kNoLabel, with an empty text
  NameTable field_names;  // fields are found by the number of their name, as texts are slow to compare

  const Function& top(std::uint32_t module) const { return *modules[module].tree.top; }
  /// The folder that asset paths of the program are relative to.
  std::filesystem::path folder() const { return modules.front().path.parent_path(); }
  /// All params, in the order in which they are met.
  std::vector<const ParamStmt*> params() const;
};

struct LoadOptions {
  /// Where imports are looked for that are not found beside the importing file; holds std/.
  std::vector<std::filesystem::path> library_folders;
};

/// Reads, parses and resolves a script and what it imports. What could be read of the sources is in `sources`
/// even when it throws, so that the diagnostics can be shown. Throws ProgramError with all mistakes found,
/// FileError if the script cannot be read.
Program load_program(const std::filesystem::path& script, const LoadOptions& options,
                     SourceSet& sources_on_error);

/// The same for a text that stands in no file; `name` is shown in messages, and imports are looked for in its
/// folder.
Program load_program_text(const std::string& name, std::string text, const LoadOptions& options,
                          SourceSet& sources_on_error);

}  // namespace solitaire
