#pragma once
#include <optional>
#include <solitaire/output.h>

#include "library/json.h"

namespace solitaire::api {

/// Returns what all files of a run have in common: "program", "params", "seed" and "engine".
Json run_json(const Program& program, const SearchOptions& options);

/// Returns what there is to say about a run as a whole, beside that: "options", "solutions", "ended" and
/// "mean_distance". It says nothing of how long things took or what was there before, so that a resumed run
/// says the same as one that was not interrupted.
Json manifest_json(const SearchOptions& options, const Summary& summary, std::optional<Ending> ending,
                   StopReason reason);

Json timings_json(const Times& times);

}  // namespace solitaire::api
