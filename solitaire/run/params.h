#pragma once
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "solitaire/names/program.h"
#include "solitaire/value/value.h"

namespace solitaire {

/// Values that replace the params' defaults.
using ParamValues = std::map<std::string, Value>;

/// Reads a param's value from the text of a command line's --set: a constant of the language. A text that is
/// no constant is taken as a string where the default is one. Throws ProgramError whose spans refer to a
/// source that is added to `sources`.
ParamValues read_params(const Program& program,
                        const std::vector<std::pair<std::string, std::string>>& settings, SourceSet& sources);

}  // namespace solitaire
