#pragma once
#include <string>
#include <vector>

#include "engines/tiles/model/problem.h"

namespace solitaire::tiles {

/// Looks for everything that is wrong with a map: sites without a tile, pairs that no exemplar has, tiles
/// that a rule forbids, broken global rules. Names at most `most` of them. It learns the pairs from the
/// exemplars anew and shares no code with the samplers, so that a mistake in those cannot hide itself.
std::vector<std::string> find_faults(const Problem& problem, const Grid& map, std::size_t most = 10);

}  // namespace solitaire::tiles
