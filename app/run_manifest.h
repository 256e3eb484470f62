#pragma once
#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "app/options.h"
#include "engines/distance.h"

namespace solitaire {

/// What there is to say about a run of generate as a whole, beside the program and its params: "options",
/// "solutions", "ended" and "mean_distance". It says nothing of how long things took or what was there
/// before, so a resumed run says the same as one that was not interrupted.
nlohmann::ordered_json run_manifest(const Options& options, const Diversity& diversity,
                                    std::optional<Ending> ending);

}  // namespace solitaire
