#pragma once
#include <stdexcept>
#include <string>

namespace solitaire {

/// A file that cannot be read or written.
class FileError : public std::runtime_error {
 public:
  FileError(const std::string& path, const std::string& reason)
      : std::runtime_error(path + ": " + reason), reason_(reason) {}

  /// The message without the path.
  const std::string& reason() const { return reason_; }

 private:
  std::string reason_;
};

}  // namespace solitaire
