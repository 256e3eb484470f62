#pragma once
#include <filesystem>

#include "engines/tiles/request/request.h"

namespace solitaire::tiles {

/// Reads a configuration file of DeBroglie, a program for WaveFunctionCollapse, as far as it has a meaning
/// here (docs/tiles.md says which members have). Throws FileError for what has none.
Request read_debroglie(const std::filesystem::path& path);

}  // namespace solitaire::tiles
