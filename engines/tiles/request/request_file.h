#pragma once
#include <filesystem>
#include <string>

#include "engines/tiles/request/request.h"

namespace solitaire::tiles {

/// Reads a problem file (.tiles.json). Paths in it are relative to its folder and must stay within it. Throws
/// FileError, naming the member that is wrong.
Request read_request(const std::filesystem::path& path);
/// The same for the text of that file.
Request parse_request(const std::filesystem::path& path, const std::string& text);

}  // namespace solitaire::tiles
