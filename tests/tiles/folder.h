#pragma once
#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>

namespace solitaire::tiles {

/// A folder with the files of a test, which lives as long as this.
class TestFolder {
 public:
  /// `name` is that of the test, since several may run at a time.
  explicit TestFolder(const std::string& name)
      : path_(std::filesystem::temp_directory_path() / (name + std::to_string(::getpid()))) {
    std::filesystem::create_directories(path_);
  }
  ~TestFolder() { std::filesystem::remove_all(path_); }
  TestFolder(const TestFolder&) = delete;
  TestFolder& operator=(const TestFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::string write(const std::string& name, const std::string& bytes) const {
    std::ofstream(path_ / name, std::ios::binary) << bytes;
    return (path_ / name).string();
  }

 private:
  std::filesystem::path path_;
};

}  // namespace solitaire::tiles
