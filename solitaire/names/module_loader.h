#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "base/file_provider.h"
#include "solitaire/names/naming.h"
#include "solitaire/names/program.h"

namespace solitaire {

struct LoadOptions {
  /// The folders in which an import is looked for that is not found beside the importing file; one holds
  /// std/.
  std::vector<std::filesystem::path> library_folders;
  /// The models that the program can place.
  std::shared_ptr<const Models> models = nullptr;
  /// The files with tiles that the program can read.
  std::shared_ptr<const TileFiles> tile_files = nullptr;
  Naming naming = Naming::kToday;
};

/// Reads and parses a script and what it imports, each file once, into an empty program. Files that are
/// missing, cannot be read, or import each other in a circle are reported. Returns the modules in the order
/// in which their names can be resolved: imported ones first.
std::vector<std::uint32_t> load_modules(const FileProvider& files, const std::filesystem::path& script,
                                        const LoadOptions& options, Program& program,
                                        Diagnostics& diagnostics);

}  // namespace solitaire
