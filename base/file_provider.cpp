#include "base/file_provider.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <utility>

#include "base/file_error.h"

namespace solitaire {
namespace {

constexpr const char* kTooLarge = "is larger than a script can be (64 MiB)";

}  // namespace

// ---- DiskFiles

std::filesystem::path DiskFiles::canonical(const std::filesystem::path& path) const {
  std::error_code error;
  if (std::filesystem::is_other(path, error)) return path;  // a pipe, whose links lead to no name
  std::filesystem::path name = std::filesystem::weakly_canonical(path, error);
  return error || name.empty() ? path.lexically_normal() : name;
}

bool DiskFiles::contains(const std::filesystem::path& file) const {
  std::error_code ignored;
  return std::filesystem::is_regular_file(file, ignored);
}

std::string DiskFiles::read(const std::filesystem::path& file) const { return read_source(file); }

std::string DiskFiles::shown_name(const std::filesystem::path& file) const {
  std::error_code error;
  const std::filesystem::path folder = std::filesystem::current_path(error);
  return error ? file.string() : file.lexically_proximate(folder).string();
}

// ---- BufferedFiles

void BufferedFiles::set(const std::filesystem::path& path, std::string text) {
  texts_[canonical(path)] = std::move(text);
}

void BufferedFiles::remove(const std::filesystem::path& path) { texts_.erase(canonical(path)); }

std::filesystem::path BufferedFiles::canonical(const std::filesystem::path& path) const {
  return behind_ != nullptr ? behind_->canonical(path) : path.lexically_normal();
}

bool BufferedFiles::contains(const std::filesystem::path& file) const {
  return texts_.count(file) > 0 || (behind_ != nullptr && behind_->contains(file));
}

std::string BufferedFiles::read(const std::filesystem::path& file) const {
  const auto it = texts_.find(file);
  if (it == texts_.end()) {
    if (behind_ == nullptr) throw FileError(file.string(), std::strerror(ENOENT));
    return behind_->read(file);
  }
  if (it->second.size() > kLargestSource) throw FileError(file.string(), kTooLarge);
  return it->second;
}

std::string BufferedFiles::shown_name(const std::filesystem::path& file) const {
  return behind_ != nullptr ? behind_->shown_name(file) : file.string();
}

// ---- the disk

std::string read_source(const std::filesystem::path& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored))
    throw FileError(path.string(), "is a folder, not a script");
  std::ifstream file(path, std::ios::binary);
  if (!file) throw FileError(path.string(), std::strerror(errno));
  std::string text;
  std::array<char, 4096> block;
  while (file.read(block.data(), static_cast<std::streamsize>(block.size())), file.gcount() > 0) {
    text.append(block.data(), static_cast<std::size_t>(file.gcount()));
    if (text.size() > kLargestSource) throw FileError(path.string(), kTooLarge);
  }
  if (file.bad()) throw FileError(path.string(), std::strerror(errno));
  return text;
}

}  // namespace solitaire
