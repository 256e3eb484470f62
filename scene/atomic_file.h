#pragma once
#include <filesystem>
#include <functional>
#include <string_view>

namespace solitaire {

/// Puts `bytes` into the file `path`: whole, or not at all. They are written to a temporary file in the same
/// folder, which then takes the name. `check`, if given, sees the temporary file before that and may throw.
/// On any failure what stood at `path` stays as it was, nothing else is left behind, and SceneError names
/// `path` and the reason. A link is replaced, too: what it leads to stays as it was. Devices and pipes, and
/// what stands in /dev, are written to directly.
///
/// This holds for whatever happens to the process. The file is not forced to the disk, which would take
/// longer than many solutions do: after a crash of the machine the same run gives the same files.
void write_file_atomically(const std::filesystem::path& path, std::string_view bytes,
                           const std::function<void(const std::filesystem::path&)>& check = nullptr);

/// Removes temporary files that processes which ended in the middle left in the folder.
void remove_abandoned_files(const std::filesystem::path& folder);

}  // namespace solitaire
