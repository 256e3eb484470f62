#pragma once
#include <optional>
#include <string>

#include "base/stop_signal.h"
#include "engines/tiles/model/problem.h"

namespace solitaire::tiles {

/// Returns how many maps keep all pairs and all rules about single sites: in digits, or as "2^123.4" where
/// that would be more than 2^127. Nothing if too much would have to be remembered at a time, for maps that
/// are wide along both axes. Global rules and soft factors are not looked at. Throws Interrupted.
std::optional<std::string> count_maps(const Problem& problem, const StopSignal& stop);

}  // namespace solitaire::tiles
