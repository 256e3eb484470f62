#pragma once
#include <filesystem>
#include <solitaire/program.h>
#include <string>
#include <utility>
#include <vector>

#include "scene/assets.h"
#include "solitaire/names/analyze.h"
#include "solitaire/names/program.h"
#include "solitaire/run/evaluator.h"

namespace solitaire::api {

struct Program::State {
  std::filesystem::path script;               // as it was named
  std::filesystem::path data;                 // see Files
  std::vector<std::filesystem::path> assets;  // see Files
  solitaire::Program program;

  /// Returns the models that the program can place.
  AssetLibrary asset_library() const;
};

/// Returns how the program was loaded.
LoadOptions load_options(const Program::State& state);

/// Returns the values of params that were set, which belong to the caller's thread. Throws Error (kUsage).
ParamValues values_of_params(const Program::State& state,
                             const std::vector<std::pair<std::string, std::string>>& settings);

}  // namespace solitaire::api
