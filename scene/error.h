#pragma once
#include <stdexcept>
#include <string>

namespace solitaire {

/// Reports a scene that cannot be built, read or written. The text names the file and the reason.
class SceneError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Reports a thing that cannot be shown as its program asks.
class ThingError : public SceneError {
 public:
  ThingError(const std::string& source, const std::string& reason, const std::string& address)
      : SceneError(source + ": " + reason + " (" + address + ")"),
        source_(source),
        reason_(reason),
        address_(address) {}

  const std::string& source() const { return source_; }    // of its place call: "a.sol:3:1"
  const std::string& reason() const { return reason_; }    // what is wrong with it
  const std::string& address() const { return address_; }  // of its place call

 private:
  std::string source_, reason_, address_;
};

}  // namespace solitaire
