#pragma once
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <solitaire/error.h>
#include <solitaire/export.h>
#include <string>
#include <utility>
#include <vector>

namespace solitaire::api {

/// Returns the folder with assets/ and std/ that was installed together with this library: share/solitaire in
/// the nearest folder above it. Throws Error (kFile) if there is none.
SOLITAIRE_API std::filesystem::path installed_data();

/// Says where a program reads from.
struct Files {
  /// Returns the text of the file with an absolute path, or nothing to have the file read from the disk. An
  /// editor gives out its buffers here. It is called while a program is loaded, and once for each job of a
  /// search.
  std::function<std::optional<std::string>(const std::filesystem::path&)> buffer = {};
  /// Holds std/, where imports are looked for that are not beside the importing file, and assets/ with the
  /// bundled models. Empty stands for installed_data().
  std::filesystem::path data = {};
  /// Further folders with models, which programs place by the names of the files without ".glb". They are
  /// looked into before the bundled ones.
  std::vector<std::filesystem::path> assets = {};
};

struct Analysis;

/// A script with what it imports, and values for its params. Copies share the script, and may be used by
/// several threads at a time; each has params of its own.
class SOLITAIRE_API Program {
 public:
  struct State;

  /// Reads a script and what it imports. Throws Error: kProgram with all errors in the texts, or kFile.
  static Program load(const std::filesystem::path& script, const Files& files = {});
  /// Does the same for a script that stands in no file. `name` is what messages call it; imports and models
  /// are looked for in its folder.
  static Program from_text(const std::string& name, const std::string& text, const Files& files = {});
  ~Program();
  Program(const Program&);
  Program& operator=(const Program&);

  /// Gives a param another value than its default: a constant of the language, as "3", "[1, 2.5]" or
  /// "\"text\""; where the default is a string, quotes may be left out. Throws Error (kUsage) if there is no
  /// such param, or if it cannot have this value.
  void set(const std::string& param, const std::string& value);
  /// Does the same with what a .json or .csv file holds, as docs/command-line.md says. Throws Error: kFile
  /// too.
  void set_from_file(const std::string& param, const std::filesystem::path& path);
  /// Returns the values that were set, in that order: name and text.
  const std::vector<std::pair<std::string, std::string>>& settings() const { return settings_; }

  /// Returns the names of all params.
  std::vector<std::string> params() const;
  /// Returns the script's name without folder and ending, and the one with its ending.
  std::string name() const;
  std::string file_name() const;

  const State& state() const { return *state_; }

 private:
  friend SOLITAIRE_API Analysis analyze(const std::filesystem::path& script, const Files& files);
  explicit Program(std::shared_ptr<const State> state);

  std::shared_ptr<const State> state_;
  std::vector<std::pair<std::string, std::string>> settings_;
};

/// The result of reading a program without running it.
struct Analysis {
  std::optional<Program> program;       // nothing if there is an error
  std::vector<Diagnostic> diagnostics;  // errors and warnings, in the order of the texts
};

/// Reads a script and what it imports. It never throws for what stands in a text, nor for a script that
/// cannot be read, which is then the diagnostic: a language server calls this whenever a text changes.
SOLITAIRE_API Analysis analyze(const std::filesystem::path& script, const Files& files = {});

}  // namespace solitaire::api
