#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "base/file_provider.h"
#include "base/source.h"

namespace solitaire {

/// Adds to each error about a name that is not there which file of the library has a function or record of
/// that name: std/layout.sol.
void suggest_imports(std::vector<Diagnostic>& diagnostics, const SourceSet& sources,
                     const FileProvider& files, const std::vector<std::filesystem::path>& library_folders);

}  // namespace solitaire
