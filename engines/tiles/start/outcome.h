#pragma once
#include <cstdint>

namespace solitaire::tiles {

/// How the search for a map, or for a part of one, ended.
enum class Outcome : std::uint8_t {
  kFound,
  kNone,     // a proof that there is nothing to find
  kStopped,  // by the signal
  kGaveUp,   // after as much effort as was allowed
};

}  // namespace solitaire::tiles
