#include "library/program_files.h"

namespace solitaire::api {

namespace fs = std::filesystem;

void ProgramFiles::set(const fs::path& path, std::string text) {
  script_ = canonical(path);
  text_ = std::move(text);
}

std::optional<std::string> ProgramFiles::buffered(const fs::path& file) const {
  if (text_ && file == script_) return text_;
  return buffer_ ? buffer_(file) : std::nullopt;
}

fs::path ProgramFiles::canonical(const fs::path& path) const { return disk_.canonical(path); }

bool ProgramFiles::contains(const fs::path& file) const { return buffered(file) || disk_.contains(file); }

std::string ProgramFiles::read(const fs::path& file) const {
  if (std::optional<std::string> text = buffered(file)) return *std::move(text);
  return disk_.read(file);
}

std::string ProgramFiles::shown_name(const fs::path& file) const { return disk_.shown_name(file); }

}  // namespace solitaire::api
