#pragma once
#include "engines/tiles/model/problem.h"
#include "engines/tiles/request/request.h"

namespace solitaire::tiles {

/// Adds what a request asks of a map as a whole: networks, paths, keys, counts, runs and distances. Throws
/// RequestError.
void add_global_rules(const Request& request, Problem& problem);

}  // namespace solitaire::tiles
