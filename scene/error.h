#pragma once
#include <stdexcept>

namespace solitaire {

/// Reports a scene that cannot be built, read or written. The text names the file and the reason.
class SceneError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace solitaire
