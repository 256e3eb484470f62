#pragma once
#include <filesystem>

namespace solitaire::api {

/// Keeps other runs out of a folder for as long as it lives, and this run out of a folder that another one
/// writes into. The operating system gives the lock back when the process ends, whatever ends it.
class FolderLock {
 public:
  /// Throws Error (kFile) where another run has the lock. A file system without locks does without.
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int descriptor_;
};

}  // namespace solitaire::api
