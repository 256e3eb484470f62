#pragma once
#include <string>

#include "engines/tiles/model/tileset.h"

namespace solitaire::tiles {

/// Reads {"size": [w, h, d], "tiles": [names], "data": [numbers of tiles]}; -1 is a hole. Other members are
/// not looked at. Names that no tile has become new tiles, if the tileset is open. Throws FileError.
Grid read_json(const std::string& name, const std::string& text, Tileset& tileset, bool open);

}  // namespace solitaire::tiles
