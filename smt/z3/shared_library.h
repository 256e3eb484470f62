#pragma once
#include <string>

namespace solitaire {

/// A library that is loaded when it is needed, and stays until the process ends.
class SharedLibrary {
 public:
  /// Throws std::runtime_error, which says why, if the file cannot be loaded.
  explicit SharedLibrary(const std::string& file);

  /// The address of a function or object; std::runtime_error if there is none of that name.
  void* symbol(const char* name) const;

 private:
  std::string file_;
  void* handle_;
};

}  // namespace solitaire
