#pragma once
#include "engines/tiles/model/problem.h"
#include "engines/tiles/request/request.h"

namespace solitaire::tiles {

/// Returns a box whose places below 0 are counted from the far side of a map of that size.
PinEntry counted_in(const Size& size, PinEntry box);

/// Adds what a request says of single sites of maps of any size: borders, and pins that are repeated. Throws
/// RequestError.
void add_site_rules_of_any_size(const Request& request, Problem& problem);

/// Adds what a request says of single sites: pins and borders. Throws RequestError and FileError.
void add_site_rules(const Request& request, Problem& problem);

}  // namespace solitaire::tiles
