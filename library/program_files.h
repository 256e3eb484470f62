#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "base/file_provider.h"

namespace solitaire::api {

/// The files of a program: buffers that somebody gives out stand in front of those of the disk.
class ProgramFiles : public FileProvider {
 public:
  using Buffer = std::function<std::optional<std::string>(const std::filesystem::path&)>;

  /// `buffer` may be empty.
  explicit ProgramFiles(Buffer buffer) : buffer_(std::move(buffer)) {}
  /// Puts a text in front of all files, for a script that stands in none.
  void set(const std::filesystem::path& path, std::string text);

  std::filesystem::path canonical(const std::filesystem::path& path) const override;
  bool contains(const std::filesystem::path& file) const override;
  std::string read(const std::filesystem::path& file) const override;
  std::string shown_name(const std::filesystem::path& file) const override;

 private:
  std::optional<std::string> buffered(const std::filesystem::path& file) const;

  Buffer buffer_;
  DiskFiles disk_;
  std::filesystem::path script_;  // the file that `text_` stands for
  std::optional<std::string> text_;
};

}  // namespace solitaire::api
