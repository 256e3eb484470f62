#pragma once
#include <stdexcept>

namespace solitaire {

/// Thrown for a choice that has values which ints of a fixed width cannot hold.
class ChoiceTooWide : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace solitaire
