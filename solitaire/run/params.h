#pragma once
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "solitaire/names/program.h"
#include "solitaire/value/value.h"

namespace solitaire {

/// Values that replace the params' defaults.
using ParamValues = std::map<std::string, Value>;

/// Thrown for a param that the program does not have. The text says which, and those that it has.
struct UnknownParam : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Throws UnknownParam unless the program has a param of that name.
void require_param(const Program& program, const std::string& name);

/// Reads a param's value from the text of a command line's --set: a constant of the language. A text that is
/// no constant is taken as a string where the default is one. Throws UnknownParam, and ProgramError whose
/// spans refer to a source that is added to `sources`.
ParamValues read_params(const Program& program,
                        const std::vector<std::pair<std::string, std::string>>& settings, SourceSet& sources);

}  // namespace solitaire
