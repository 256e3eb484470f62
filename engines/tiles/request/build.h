#pragma once
#include <memory>

#include "engines/tiles/model/problem.h"
#include "engines/tiles/request/request.h"
#include "engines/tiles/request/request_error.h"

namespace solitaire::tiles {

/// Reads tiles and exemplars and learns their pairs. Throws FileError and RequestError.
std::shared_ptr<Style> read_style(const Request& request);

/// Returns the problem of the request's size, pins, zones and rules. Throws FileError and RequestError.
Problem make_problem(const Request& request, std::shared_ptr<const Style> style);

}  // namespace solitaire::tiles
