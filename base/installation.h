#pragma once
#include <filesystem>

namespace solitaire {

// An installation can be moved as a whole: its parts are looked for from the place of the running code
// upwards. The build folder is laid out in the same way.

/// Returns the folder with assets/ and std/: share/solitaire in the nearest folder above the running code
/// that has it. Throws FileError if there is none.
std::filesystem::path find_data_folder();

}  // namespace solitaire
