#pragma once
#include <memory>

#include "engines/tiles/model/style.h"
#include "engines/tiles/request/request.h"

namespace solitaire::tiles {

/// Reads tiles and exemplars and learns their pairs. Throws FileError and RequestError.
std::shared_ptr<Style> read_style(const Request& request);

}  // namespace solitaire::tiles
