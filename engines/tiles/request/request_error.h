#pragma once
#include <stdexcept>

namespace solitaire::tiles {

/// A request that contradicts itself or names what is not there. The text says what to do.
class RequestError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace solitaire::tiles
