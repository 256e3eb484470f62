#pragma once
#include <memory>

#include "app/options.h"
#include "engines/tracing.h"
#include "solitaire/program.h"

namespace solitaire {

/// A script that is loaded, with its params set: what every subcommand starts from.
class Session {
 public:
  /// Throws Reported after it told of what is wrong with the program or its pins, and FileError.
  explicit Session(const Options& options);

  const Program& program() const { return program_; }
  const ParamValues& params() const { return params_; }
  TracingOptions tracing_options() const;
  /// The script's name without folder and ending.
  std::string name() const;

 private:
  const Options& options_;
  Program program_;
  ParamValues params_;
  std::vector<Pin> pins_;
};

/// The folder with std/ and assets/.
std::filesystem::path data_folder();

}  // namespace solitaire
