#pragma once
#include <filesystem>
#include <string>

namespace solitaire {

// An installation can be moved as a whole: its parts are looked for from the place of the running code
// upwards. The build folder is laid out in the same way.

/// Returns the file of a module, which is loaded only when it is needed: solitaire/NAME or lib/solitaire/NAME
/// in the folder of the program or shared library that this code is part of, or in the nearest folder above
/// that has it. Throws FileError if there is none.
std::filesystem::path find_module(const std::string& name);

/// Returns the folder with assets/ and std/: share/solitaire in the nearest folder above the running code
/// that has it. Throws FileError if there is none.
std::filesystem::path find_data_folder();

}  // namespace solitaire
