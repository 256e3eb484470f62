#pragma once
#include <filesystem>
#include <optional>
#include <solitaire/solution.h>
#include <string>
#include <vector>

#include "library/json.h"

namespace solitaire::api {

/// Reads the .json file of a solution, or a line of to_json(). Throws Error (kFile) if it is none.
Json read_solution_file(const std::filesystem::path& path);

struct EarlierSolution {
  std::vector<Choice> choices;
  std::optional<bool> optimal;  // where solutions are better and worse
  std::optional<std::int64_t> least_cost;
};

/// Reads the solutions that an earlier run left in a folder: NAME-0001.json and those that follow it without
/// a gap. `expected` is what their files have to say of the run: members and values, as "seed". Throws Error:
/// kFile for a file that cannot be read, is no solution's, or comes from another run; kUsage where the
/// options were others.
std::vector<EarlierSolution> read_earlier_run(const std::filesystem::path& folder, const std::string& name,
                                              const Json& expected);

}  // namespace solitaire::api
