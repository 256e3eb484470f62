#pragma once
#include <filesystem>
#include <functional>
#include <string_view>

namespace solitaire {

/// Puts `bytes` into the file `path`: whole, or not at all. They are written to a temporary file in the same
/// folder, which then takes the name. `check`, if given, sees the temporary file before that and may throw.
/// On any failure what stood at `path` stays as it was, nothing else is left behind, and SceneError names
/// `path` and the reason. Devices and pipes (/dev/stdout) are written to directly.
void write_file_atomically(const std::filesystem::path& path, std::string_view bytes,
                           const std::function<void(const std::filesystem::path&)>& check = nullptr);

}  // namespace solitaire
