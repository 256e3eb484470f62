#pragma once
#include <functional>
#include <vector>

#include "engines/solution.h"

namespace solitaire {

/// Makes solutions that are known from before, each by `run`. Throws NotASolution, whose message names the
/// one that is none, and what else `run` throws.
std::vector<Solution> run_all(const std::vector<ChosenValues>& known,
                              const std::function<Solution(const ChosenValues&)>& run);

}  // namespace solitaire
