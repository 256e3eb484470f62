#pragma once
#include <cstddef>
#include <filesystem>
#include <map>
#include <string>

namespace solitaire {

/// No text of a program is larger than this, in bytes: positions in it are 32 bits, and no script that a
/// person or a tool writes comes near.
constexpr std::size_t kLargestSource = std::size_t{64} << 20;

/// Gives the texts of a program. The language reads files by this alone, so that an editor or an
/// embedding program can put its own texts in the place of files.
class FileProvider {
 public:
  virtual ~FileProvider() = default;

  /// Returns the one name of the file that a path leads to, however the path is written. The file need not
  /// exist.
  virtual std::filesystem::path canonical(const std::filesystem::path& path) const = 0;
  /// Returns true if there is a file of that canonical name.
  virtual bool contains(const std::filesystem::path& file) const = 0;
  /// Returns the text of a file. Throws FileError if it cannot be read or is larger than kLargestSource.
  virtual std::string read(const std::filesystem::path& file) const = 0;
  /// Returns the name by which messages speak of a file.
  virtual std::string shown_name(const std::filesystem::path& file) const = 0;
};

/// The files of the disk. Messages name them relative to the working folder.
class DiskFiles final : public FileProvider {
 public:
  std::filesystem::path canonical(const std::filesystem::path& path) const override;
  bool contains(const std::filesystem::path& file) const override;
  std::string read(const std::filesystem::path& file) const override;
  std::string shown_name(const std::filesystem::path& file) const override;
};

/// Texts in memory, in front of other files: what an editor shows and has not saved yet, or the whole of a
/// program that stands in no file.
class BufferedFiles final : public FileProvider {
 public:
  /// The files behind have to outlive this object. Without any, there are only the texts.
  explicit BufferedFiles(const FileProvider* behind = nullptr) : behind_(behind) {}

  /// Sets or replaces the text that stands for a file.
  void set(const std::filesystem::path& path, std::string text);
  /// Lets the file behind be seen again.
  void remove(const std::filesystem::path& path);

  std::filesystem::path canonical(const std::filesystem::path& path) const override;
  bool contains(const std::filesystem::path& file) const override;
  std::string read(const std::filesystem::path& file) const override;
  std::string shown_name(const std::filesystem::path& file) const override;

 private:
  const FileProvider* behind_;
  std::map<std::filesystem::path, std::string> texts_;  // by canonical name
};

/// Reads a whole file of the disk. Throws FileError if it cannot be read or is larger than kLargestSource.
std::string read_source(const std::filesystem::path& path);

}  // namespace solitaire
