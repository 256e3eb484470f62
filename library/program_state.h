#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <solitaire/program.h>
#include <string>
#include <utility>
#include <vector>

#include "engines/solve/background_search.h"
#include "solitaire/names/analyze.h"
#include "solitaire/names/program.h"
#include "solitaire/run/evaluator.h"

namespace solitaire::api {

struct Program::State {
  std::filesystem::path script;  // as it was named
  std::filesystem::path data;    // see Files
  solitaire::Program program;
  std::function<solitaire::Program()> load_again;  // for searches at work beside each other
};

/// Returns the values of params that were set, which belong to the caller's thread. Throws Error (kUsage).
ParamValues values_of_params(const Program::State& state,
                             const std::vector<std::pair<std::string, std::string>>& settings);

/// Returns the program so many times over, for searches at work beside each other.
std::vector<std::shared_ptr<const OwnProgram>> programs_for_workers(const Program& program,
                                                                    std::size_t number);

}  // namespace solitaire::api
