#pragma once
#include <memory>

#include "app/options.h"
#include "base/file_error.h"
#include "engines/solve/background_search.h"
#include "solitaire/names/program.h"

namespace solitaire {

/// A script that is loaded, with its params set: what every subcommand starts from.
class Session {
 public:
  /// Throws Reported after it told of what is wrong with the program or its pins, and FileError.
  explicit Session(const Options& options);

  const Program& program() const { return own_.program; }
  const ParamValues& params() const { return own_.params; }
  TracingOptions tracing_options() const;
  /// The program and its params so many times over, for searches beside each other. Throws as the
  /// constructor.
  std::vector<std::shared_ptr<const OwnProgram>> own_programs(std::size_t number) const;
  /// The script's name without folder and ending.
  std::string name() const;

 private:
  static OwnProgram load(const Options& options);

  const Options& options_;
  OwnProgram own_;
  std::vector<Pin> pins_;
};

/// The folder with std/ and assets/.
std::filesystem::path data_folder();

}  // namespace solitaire
