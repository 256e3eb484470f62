#include "solitaire/names/module_loader.h"

#include <algorithm>
#include <fmt/format.h>
#include <string_view>

#include "base/file_error.h"
#include "solitaire/syntax/parser.h"

namespace solitaire {
namespace {

/// No more files than this may import each other in a chain, as reading them takes stack for each.
constexpr std::size_t kLongestChain = 100;

class ModuleLoader {
 public:
  ModuleLoader(const FileProvider& files, const LoadOptions& options, Program& program,
               Diagnostics& diagnostics)
      : files_(files), options_(options), program_(program), diagnostics_(diagnostics) {}

  std::vector<std::uint32_t> run(const std::filesystem::path& script) {
    const std::filesystem::path path = files_.canonical(script);
    std::string text;
    std::string fault;
    try {
      text = files_.read(path);
    } catch (const FileError& error) {
      fault = error.reason();
    }
    if (!fault.empty()) diagnostics_.add("unreadable-script", {}, fault);
    load(path, script.string(), std::move(text));
    return std::move(order_);
  }

 private:
  struct Loading {
    std::uint32_t module;
    Span import;  // what led here; empty for the script
  };

  /// Loads a file and, before it counts as loaded, what it imports.
  std::uint32_t load(const std::filesystem::path& path, std::string name, std::string text,
                     bool is_library = false, Span import = {}) {
    const auto number = static_cast<std::uint32_t>(program_.modules.size());
    Module module;
    module.path = path;
    module.label = number == 0 || options_.naming == Naming::kAfterFunctions ? "" : new_label(path);
    module.is_library = is_library;
    module.source = program_.sources.add(std::move(name), std::move(text));
    module.tree = parse(program_.sources, module.source, diagnostics_);
    program_.modules.push_back(std::move(module));
    loading_.push_back({number, import});
    for (ImportStmt* statement : imports_of(number)) load_import(number, *statement);
    loading_.pop_back();
    order_.push_back(number);
    return number;
  }

  std::vector<ImportStmt*> imports_of(std::uint32_t module) {
    std::vector<ImportStmt*> imports;
    for (const StmtPtr& statement : program_.modules[module].tree.top->body->statements) {
      if (statement->kind == StmtKind::kImport) imports.push_back(static_cast<ImportStmt*>(statement.get()));
    }
    return imports;
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
    if (const auto module = imported_module(importer, import)) {
      import.module = *module;
      program_.modules[importer].imports.push_back(*module);
    } else {
      program_.modules[importer].imports_known = false;
    }
  }

  /// A file that an import means.
  struct Located {
    std::filesystem::path path;
    bool is_library;
  };

  /// Returns the module that an import means, which is loaded if it is not yet; nothing if that fails.
  std::optional<std::uint32_t> imported_module(std::uint32_t importer, const ImportStmt& import) {
    if (!import.is_complete) return std::nullopt;
    const auto file = find(program_.modules[importer], import.path);
    if (!file) {
      diagnostics_.add(
          "missing-import", import.path_span, fmt::format("there is no file '{}'", import.path),
          "imports are looked for beside this file, then in the library, which has std/layout.sol");
      return std::nullopt;
    }
    if (const auto known = find_module(file->path)) {
      if (!is_loading(*known)) return known;
      report_circle(*known, import);
      return std::nullopt;
    }
    return new_module(*file, import);
  }

  std::optional<std::uint32_t> new_module(const Located& file, const ImportStmt& import) {
    if (loading_.size() >= kLongestChain) {
      diagnostics_.add("import-chain", import.path_span,
                       fmt::format("more than {} files import each other in a chain", kLongestChain));
      return std::nullopt;
    }
    std::string text;
    try {
      text = files_.read(file.path);
    } catch (const FileError& error) {
      diagnostics_.add("unreadable-import", import.path_span, error.what());
      return std::nullopt;
    }
    return load(file.path, files_.shown_name(file.path), std::move(text), file.is_library, import.span);
  }

  std::optional<std::uint32_t> find_module(const std::filesystem::path& path) const {
    const auto it =
        std::ranges::find_if(program_.modules, [&](const Module& module) { return module.path == path; });
    if (it == program_.modules.end()) return std::nullopt;
    return static_cast<std::uint32_t>(it - program_.modules.begin());
  }

  bool is_loading(std::uint32_t module) const {
    return std::ranges::any_of(loading_, [&](const Loading& each) { return each.module == module; });
  }

  void report_circle(std::uint32_t first, const ImportStmt& import) {
    Diagnostic diagnostic{import.span,
                          fmt::format("'{}' is imported in a circle", import.path),
                          "move what both files need into a third one",
                          {},
                          Severity::kError,
                          "circular-import",
                          {}};
    auto at = std::ranges::find_if(loading_, [&](const Loading& each) { return each.module == first; });
    while (++at != loading_.end())
      diagnostic.related.push_back({at->import, "the circle leads through here"});
    diagnostics_.add(std::move(diagnostic));
  }

  /// What a file of the library imports from beside itself is of the library, too.
  std::optional<Located> find(const Module& importer, const std::string& name) const {
    const auto located = [&](const std::filesystem::path& folder, bool is_library) -> std::optional<Located> {
      std::filesystem::path path = files_.canonical(folder / name);
      if (!files_.contains(path)) return std::nullopt;
      return Located{std::move(path), is_library};
    };
    if (auto beside = located(importer.path.parent_path(), importer.is_library)) return beside;
    for (const std::filesystem::path& folder : options_.library_folders) {
      if (auto found = located(folder, true)) return found;
    }
    return std::nullopt;
  }

  const FileProvider& files_;
  const LoadOptions& options_;
  Program& program_;
  Diagnostics& diagnostics_;
  std::vector<Loading> loading_;  // the files that are being read, each imported by the one before
  std::vector<std::uint32_t> order_;
};

}  // namespace

std::vector<std::uint32_t> load_modules(const FileProvider& files, const std::filesystem::path& script,
                                        const LoadOptions& options, Program& program,
                                        Diagnostics& diagnostics) {
  return ModuleLoader(files, options, program, diagnostics).run(script);
}

}  // namespace solitaire
