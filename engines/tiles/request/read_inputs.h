#pragma once
#include <string>
#include <vector>

#include "engines/tiles/request/request.h"

namespace solitaire::tiles {

/// Returns the request of exemplars, or of a problem file (.tiles.json) where that is the only input; with
/// `debroglie`, of a configuration file of DeBroglie. Throws FileError, and RequestError for several of
/// these.
Request read_inputs(const std::vector<std::string>& inputs, bool debroglie = false);

}  // namespace solitaire::tiles
