#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "engines/tiles/model/mirror.h"
#include "engines/tiles/model/problem.h"
#include "engines/tiles/request/request.h"
#include "engines/tiles/request/request_error.h"

namespace solitaire::tiles {

/// Returns the problem of the request's size, pins, zones and rules. Throws FileError and RequestError.
Problem make_problem(const Request& request, std::shared_ptr<const Style> style);

/// Returns, for each tile of a coarse map, the number of the zone that it is. Throws RequestError for a tile
/// that is named like none.
std::vector<std::uint8_t> zones_by_tile(const Request& request, const Tileset& coarse);

/// Returns the mirror that the request asks for, if it does, of a problem whose weights have been learned.
/// Throws RequestError where such a map cannot be mirrored.
std::optional<Mirror> make_mirror(const Request& request, const Problem& problem);

}  // namespace solitaire::tiles
