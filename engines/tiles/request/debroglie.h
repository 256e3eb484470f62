#pragma once
#include <filesystem>
#include <string>

#include "engines/tiles/request/request.h"

namespace solitaire::tiles {

/// Reads a configuration file of DeBroglie, a program for WaveFunctionCollapse, as far as it has a meaning
/// here (docs/tiles.md says which members have). Throws FileError for what has none.
Request read_debroglie(const std::filesystem::path& path);
/// The same for the text of that file.
Request parse_debroglie(const std::filesystem::path& path, const std::string& text);

}  // namespace solitaire::tiles
