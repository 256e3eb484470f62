#include "engines/tiles/read/file.h"

#include <cerrno>
#include <fmt/format.h>
#include <fstream>
#include <system_error>

namespace solitaire::tiles {

std::string read_bytes(const std::filesystem::path& path) {
  if (std::filesystem::is_directory(path)) throw FileError(path.string(), "is a folder, not a file");
  std::ifstream file(path, std::ios::binary);
  if (!file) throw FileError(path.string(), std::generic_category().message(errno));
  std::string bytes;
  char part[1 << 16];
  while (file.read(part, sizeof part) || file.gcount() > 0) {
    bytes.append(part, static_cast<std::size_t>(file.gcount()));
    if (bytes.size() > kMostBytes) {
      throw FileError(path.string(), fmt::format("is larger than {} MB", kMostBytes >> 20U));
    }
  }
  if (file.bad()) throw FileError(path.string(), "cannot be read to its end");
  return bytes;
}

}  // namespace solitaire::tiles
