#pragma once
#include "engines/tiles/model/tileset.h"
#include "engines/tiles/request/request.h"

namespace solitaire::tiles {

/// Adds the tiles that a request lists, with their turned and mirrored images. Throws RequestError and
/// FileError.
void add_listed_tiles(const Request& request, Tileset& tileset);

/// Adds to tiles what a request says of them beside the exemplars that they come from. Throws RequestError.
void add_remarks(const Request& request, Tileset& tileset);

}  // namespace solitaire::tiles
