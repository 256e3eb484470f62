#include "base/installation.h"

#include <dlfcn.h>
#include <initializer_list>
#include <link.h>

#include "base/file_error.h"

namespace solitaire {
namespace {

namespace fs = std::filesystem;

/// Returns the program or shared library that this function was linked into.
fs::path this_binary() {
  Dl_info info{};
  link_map* loaded = nullptr;
  const void* const code = reinterpret_cast<const void*>(&this_binary);
  const bool found = dladdr1(code, &info, reinterpret_cast<void**>(&loaded), RTLD_DL_LINKMAP) != 0;
  // The program itself is loaded without a name.
  if (!found || loaded->l_name[0] == '\0') return fs::read_symlink("/proc/self/exe");
  return fs::weakly_canonical(loaded->l_name);
}

fs::path find_upwards(std::initializer_list<fs::path> candidates, const std::string& what) {
  const fs::path start = this_binary().parent_path();
  for (fs::path folder = start;; folder = folder.parent_path()) {
    for (const fs::path& candidate : candidates) {
      std::error_code ignored;
      if (fs::exists(folder / candidate, ignored)) return folder / candidate;
    }
    if (folder == folder.root_path()) break;
  }
  throw FileError(start.string(),
                  what + " is found neither here nor in a folder above; is the installation whole?");
}

}  // namespace

fs::path find_data_folder() { return find_upwards({"share/solitaire"}, "share/solitaire"); }

}  // namespace solitaire
