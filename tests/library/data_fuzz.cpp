// Whatever a file of data holds, it is refused with an Error, or what comes of it is a constant of the
// language. The first byte says which kind of file it is.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <solitaire/error.h>
#include <string>

#include "library/data_file.h"
#include "solitaire/names/analyze.h"

namespace {

namespace fs = std::filesystem;

/// The folder of this process. It stays, as libFuzzer ends without a word.
const fs::path& folder() {
  static const fs::path made = [] {
    std::string name = (fs::temp_directory_path() / "solitaire-data-fuzz-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) std::abort();
    return fs::path(name);
  }();
  return made;
}

/// Whether the language reads a constant; that too much nests in each other is no fault of it.
bool is_read(const std::string& constant) {
  solitaire::BufferedFiles files;
  files.set("fuzz.sol", "x = " + constant + ";\n");
  const solitaire::Analysis analysis = solitaire::analyze(files, "fuzz.sol", {});
  for (const auto& diagnostic : analysis.diagnostics) {
    if (diagnostic.message.find("nest") != std::string::npos) return true;
    std::fprintf(stderr, "%s\n", diagnostic.message.c_str());
  }
  return analysis.diagnostics.empty();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  const fs::path file = folder() / (data[0] % 2 == 0 ? "data.csv" : "data.json");
  std::ofstream(file, std::ios::binary) << bytes;
  std::string constant;
  try {
    constant = solitaire::api::constant_of_file(file);
  } catch (const solitaire::api::Error&) {
    return 0;
  }
  if (!is_read(constant)) {
    std::fprintf(stderr, "no constant: %s\n", constant.c_str());
    std::abort();
  }
  return 0;
}
