#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "base/source.h"
#include "engines/engine.h"

namespace solitaire {

/// {"value": ..., "choices": [{"at": ..., "value": ...}, ...]}, and of a solution that is better or worse
/// than others "cost", "optimal" and "broken".
nlohmann::ordered_json solution_json(const Solution& solution, const SourceSet& sources);

/// The same with its number, as a line of output.
std::string solution_line(std::uint64_t number, const Solution& solution, const SourceSet& sources);

/// As text, on one line or, indented, on several; broken UTF-8 is replaced.
std::string json_text(const nlohmann::ordered_json& json, int indent = -1);

/// "cost 5, the best there is", or "" where solutions are all as good.
std::string quality_text(const Solution& solution);
/// A broken assert on a line: "room.sol:3:8: table.x < 4 (at room[2]/assert)".
std::string broken_text(const Rejection& broken, const SourceSet& sources);

}  // namespace solitaire
