#pragma once
#include <filesystem>
#include <string>

#include "base/file_error.h"

namespace solitaire::tiles {

/// The largest file that is read.
inline constexpr std::size_t kMostBytes = std::size_t{64} << 20U;

/// Reads a whole file. Throws FileError if it cannot be read or has more than kMostBytes.
std::string read_bytes(const std::filesystem::path& path);

}  // namespace solitaire::tiles
