#pragma once
#include <string>
#include <string_view>

#include "engines/tiles/model/tileset.h"

namespace solitaire::tiles {

/// Reads a map of characters, a tile each; UTF-8, rows from the top, an empty line before each further layer.
/// Characters that no tile has become new tiles, if the tileset is open. `name` is the file's, for messages.
/// Throws FileError, naming line and column.
Grid read_text(const std::string& name, std::string_view text, Tileset& tileset, bool open);

}  // namespace solitaire::tiles
