#pragma once
#include <optional>
#include <string>
#include <vector>

#include "base/stop_signal.h"
#include "engines/tiles/model/problem.h"

namespace solitaire::tiles {

/// Why there is no map.
struct NoMap {
  std::vector<std::string> rules;  // rules about single sites; each of them is needed for the contradiction
};

/// Finds a smallest set of rules about single sites that the pairs contradict: without any one of them there
/// would be maps. The set is empty if the pairs alone allow no map of this size. Nothing if there is a map,
/// by all that is looked at here: global rules are not. Throws Interrupted.
std::optional<NoMap> explain_no_map(const Problem& problem, const StopSignal& stop);

/// Returns warnings about tiles of the exemplars: those that can be nowhere but at a border of a map, as
/// nothing may be on one of their sides.
std::vector<std::string> tiles_that_need_a_border(const Problem& problem);

}  // namespace solitaire::tiles
