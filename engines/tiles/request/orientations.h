#pragma once
#include "engines/tiles/model/style.h"
#include "engines/tiles/request/request.h"

namespace solitaire::tiles {

/// Adds the turned and mirrored images of exemplars and listed pairs that a request asks for. A tile without
/// such an image leaves a hole, of which nothing is learned. Throws RequestError where nothing at all is
/// known of how tiles look when they are turned.
void add_orientations(const Request& request, Style& style);

}  // namespace solitaire::tiles
