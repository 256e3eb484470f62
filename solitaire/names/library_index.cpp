#include "solitaire/names/library_index.h"

#include <algorithm>
#include <fmt/format.h>
#include <system_error>

#include "base/file_error.h"

namespace solitaire {
namespace {

namespace fs = std::filesystem;

struct LibraryFile {
  std::string name;  // as programs import it
  std::string text;
};

std::vector<LibraryFile> files_of_library(const FileProvider& files, const std::vector<fs::path>& folders) {
  std::vector<LibraryFile> found;
  for (const fs::path& folder : folders) {
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(folder / "std", none)) {
      if (entry.path().extension() != ".sol") continue;
      try {
        found.push_back({"std/" + entry.path().filename().string(), "\n" + files.read(entry.path())});
      } catch (const FileError&) {  // whoever imports it is told
      }
    }
  }
  std::ranges::sort(found, {}, &LibraryFile::name);
  return found;
}

/// Definitions of the library stand at the start of a line.
bool defines(const LibraryFile& file, const std::string& name) {
  return file.text.find(fmt::format("\nfun {}(", name)) != std::string::npos ||
         file.text.find(fmt::format("\nrecord {}(", name)) != std::string::npos;
}

}  // namespace

void suggest_imports(std::vector<Diagnostic>& diagnostics, const SourceSet& sources,
                     const FileProvider& files, const std::vector<fs::path>& library_folders) {
  std::vector<LibraryFile> library;
  for (Diagnostic& diagnostic : diagnostics) {
    if (diagnostic.code != "unknown-name") continue;
    if (library.empty()) library = files_of_library(files, library_folders);
    const std::string name(sources.text(diagnostic.span));
    const auto file =
        std::ranges::find_if(library, [&](const LibraryFile& each) { return defines(each, name); });
    if (file != library.end()) diagnostic.help = fmt::format("it comes by import \"{}\";", file->name);
  }
}

}  // namespace solitaire
