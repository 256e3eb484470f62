#pragma once
#include <string>
#include <vector>

#include "engines/tiles/request/request.h"

namespace solitaire::tiles {

/// Returns the request of exemplars, or of a problem file (.tiles.json) where that is the only input. Throws
/// FileError.
Request read_inputs(const std::vector<std::string>& inputs);

}  // namespace solitaire::tiles
