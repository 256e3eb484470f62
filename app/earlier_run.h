#pragma once
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "base/file_error.h"
#include "engines/solve/tracing.h"

namespace solitaire {

struct EarlierSolution {
  KnownChoices choices;
  std::optional<bool> optimal;  // where solutions are better and worse
};

/// The solutions that an earlier run of generate left in a folder: NAME-0001.json and those that follow it
/// without a gap. `expected` is what their files have to say of the run: members and values, as "seed".
/// Throws FileError for a file that cannot be read, is none of generate's, or comes from another run.
std::vector<EarlierSolution> read_earlier_run(const std::filesystem::path& folder, const std::string& name,
                                              const nlohmann::ordered_json& expected);

}  // namespace solitaire
