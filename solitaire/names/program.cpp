#include "solitaire/names/program.h"

#include <algorithm>
#include <fmt/format.h>
#include <string_view>

#include "base/file_error.h"
#include "solitaire/names/resolver.h"
#include "solitaire/syntax/parser.h"

namespace solitaire {
namespace {

class Loader {
 public:
  explicit Loader(const LoadOptions& options) : options_(options) { program_.labels.number(""); }

  Program run(const std::filesystem::path& path, std::string name, std::string text) {
    load(path, std::move(name), std::move(text));
    diagnostics_.raise_if_any();
    for (const std::uint32_t module : order_) resolve(program_, module, diagnostics_);
    diagnostics_.raise_if_any();
    return std::move(program_);
  }

  SourceSet& sources() { return program_.sources; }

 private:
  /// Loads a file and, before it counts as loaded, what it imports.
  std::uint32_t load(const std::filesystem::path& path, std::string name, std::string text) {
    const auto number = static_cast<std::uint32_t>(program_.modules.size());
    const std::uint32_t source = program_.sources.add(std::move(name), std::move(text));
    std::string label = number == 0 ? "" : new_label(path);
    program_.modules.push_back(
        {path, std::move(label), source, parse(program_.sources, source, diagnostics_), {}, {}});
    loading_.push_back(number);
    // The vector of modules grows in the loop; the statements themselves stay where they are.
    const std::vector<StmtPtr>& statements = program_.modules[number].tree.top->body->statements;
    std::vector<ImportStmt*> imports;
    for (const StmtPtr& statement : statements) {
      if (statement->kind == StmtKind::kImport) imports.push_back(static_cast<ImportStmt*>(statement.get()));
    }
    for (ImportStmt* import : imports) load_import(number, *import);
    loading_.pop_back();
    order_.push_back(number);
    return number;
  }

  /// Makes a Module::label that no module has yet. Characters that mean something in an address, or in a
  /// pattern over addresses, are replaced.
  std::string new_label(const std::filesystem::path& path) const {
    std::string name = path.stem().string();
    std::ranges::replace_if(
        name, [](char c) { return std::string_view("/[]*#=").find(c) != std::string_view::npos; }, '_');
    name += ".sol";
    const auto is_taken = [this](const std::string& label) {
      return std::ranges::any_of(program_.modules, [&](const Module& other) { return other.label == label; });
    };
    std::string label = name;
    for (int count = 2; is_taken(label); ++count) label = fmt::format("{}#{}", name, count);
    return label;
  }

  void load_import(std::uint32_t importer, ImportStmt& import) {
    const std::filesystem::path path = find(program_.modules[importer].path.parent_path(), import.path);
    if (path.empty()) {
      diagnostics_.add(
          import.path_span, fmt::format("there is no file '{}'", import.path),
          "imports are looked for beside this file, then in the library, which has std/layout.sol");
      return;
    }
    for (std::uint32_t module = 0; module < program_.modules.size(); ++module) {
      if (program_.modules[module].path != path) continue;
      if (std::find(loading_.begin(), loading_.end(), module) != loading_.end()) {
        diagnostics_.add(import.span, fmt::format("'{}' is imported in a circle", import.path),
                         "move what both files need into a third one");
      }
      return link(importer, import, module);
    }
    try {
      link(importer, import,
           load(path, path.lexically_proximate(std::filesystem::current_path()).string(), read_source(path)));
    } catch (const FileError& error) {
      diagnostics_.add(import.path_span, error.what());
    }
  }

  void link(std::uint32_t importer, ImportStmt& import, std::uint32_t module) {
    import.module = module;
    program_.modules[importer].imports.push_back(module);
  }

  std::filesystem::path find(const std::filesystem::path& folder, const std::string& name) const {
    std::vector<std::filesystem::path> folders{folder};
    folders.insert(folders.end(), options_.library_folders.begin(), options_.library_folders.end());
    for (const auto& candidate : folders) {
      std::error_code ignored;
      const auto path = std::filesystem::weakly_canonical(candidate / name, ignored);
      if (std::filesystem::is_regular_file(path, ignored)) return path;
    }
    return {};
  }

  const LoadOptions& options_;
  Program program_;
  Diagnostics diagnostics_;
  std::vector<std::uint32_t> loading_;
  std::vector<std::uint32_t> order_;  // imported ones first
};

Program load_with(const std::filesystem::path& path, const std::string& name, std::string text,
                  const LoadOptions& options, SourceSet& sources_on_error) {
  Loader loader(options);
  try {
    return loader.run(path, name, std::move(text));
  } catch (const ProgramError&) {
    sources_on_error = std::move(loader.sources());
    throw;
  }
}

void collect_params(const Program& program, std::uint32_t module, std::vector<bool>& seen,
                    std::vector<const ParamStmt*>& params) {
  if (seen[module]) return;
  seen[module] = true;
  for (const std::uint32_t imported : program.modules[module].imports)
    collect_params(program, imported, seen, params);
  for (const StmtPtr& statement : program.top(module).body->statements) {
    if (statement->kind == StmtKind::kParam) params.push_back(static_cast<const ParamStmt*>(statement.get()));
  }
}

}  // namespace

std::vector<const ParamStmt*> Program::params() const {
  std::vector<const ParamStmt*> params;
  std::vector<bool> seen(modules.size());
  collect_params(*this, 0, seen, params);
  return params;
}

Program load_program(const std::filesystem::path& script, const LoadOptions& options,
                     SourceSet& sources_on_error) {
  std::string text = read_source(script);
  std::error_code ignored;
  return load_with(std::filesystem::weakly_canonical(script, ignored), script.string(), std::move(text),
                   options, sources_on_error);
}

Program load_program_text(const std::string& name, std::string text, const LoadOptions& options,
                          SourceSet& sources_on_error) {
  std::error_code ignored;
  return load_with(std::filesystem::weakly_canonical(name, ignored), name, std::move(text), options,
                   sources_on_error);
}

}  // namespace solitaire
