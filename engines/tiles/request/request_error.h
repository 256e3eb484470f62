#pragma once
#include <stdexcept>
#include <string>

namespace solitaire::tiles {

/// A request that contradicts itself or names what is not there. The text says what to do.
class RequestError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Does something that somebody asked for, and says where in front of what is wrong with it. `where` is empty
/// where the text itself is enough.
template <class Work>
void said_at(const std::string& where, Work work) {
  try {
    work();
  } catch (const RequestError& error) {
    if (where.empty()) throw;
    throw RequestError(where + ": " + error.what());
  }
}

}  // namespace solitaire::tiles
