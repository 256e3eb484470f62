#pragma once
#include "engines/tiles/model/problem.h"
#include "engines/tiles/request/request.h"

namespace solitaire::tiles {

/// Adds what a request says of single sites: pins and borders. Throws RequestError and FileError.
void add_site_rules(const Request& request, Problem& problem);

}  // namespace solitaire::tiles
