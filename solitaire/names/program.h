#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "base/name_table.h"
#include "base/source.h"
#include "solitaire/names/models.h"
#include "solitaire/names/tile_pairs.h"
#include "solitaire/syntax/syntax.h"

namespace solitaire {

/// One file of a program. Its top-level names are what an import of it brings.
struct Module {
  std::filesystem::path path;  // the canonical name of the file
  /// The step that stands for this file in the addresses of what its top level does: "part.sol", with "#2"
  /// behind it if another file of that name came before. Its dot keeps it apart from the labels of calls.
  /// Empty for the script itself.
  std::string label;
  std::uint32_t source = 0;
  SyntaxTree tree;
  std::vector<std::uint32_t> imports;  // modules, in the order of the import statements
  bool is_library = false;             // it comes from a library folder: std/layout.sol
  bool imports_known = true;           // false if an import is missing or circular, and names with it
  std::map<std::string, Slot> names;   // the variables of the top level
};

/// A resolved program: modules[0] is the script itself. It is immutable once loaded, and nothing in it counts
/// references, so that many evaluations can share it, also on several threads. (The values of params do count
/// references: each thread needs copies of its own.)
struct Program {
  SourceSet sources;
  std::vector<Module> modules;
  NameTable labels;       // the labels of all sites; the first is kNoLabel, with an empty text
  NameTable field_names;  // fields are found by the number of their name, as texts are slow to compare
  std::shared_ptr<const Models> models;         // that it can place; null where nobody knows any
  std::shared_ptr<const TileFiles> tile_files;  // that it can read; null where nobody reads any
  std::vector<Diagnostic> warnings;  // what is allowed and hardly meant, in the order of the sources

  /// Returns true if the function is one of the library.
  bool is_library(const Function& function) const;
  const Function& top(std::uint32_t module) const { return *modules[module].tree.top; }
  /// Returns the folder that asset paths of the program are relative to.
  std::filesystem::path folder() const { return modules.front().path.parent_path(); }
  /// The output of the script, or null.
  const OutputStmt* output() const;
  /// Returns all params, in the order in which they are met.
  std::vector<const ParamStmt*> params() const;
};

}  // namespace solitaire
