#pragma once
#include <cstdint>

namespace solitaire {

/// How addresses name choices: as today, or as earlier versions did, whose files of solutions are still read.
enum class Naming : std::uint8_t {
  kToday,
  /// What a function returns that the library made is below a step of its own: `seat/anywhere/x`.
  kWithWrappers,
  /// Besides, what the library makes is named after its function and not after what it is for, fields are
  /// named without their variable, and imports are no steps.
  kAfterFunctions,
};

}  // namespace solitaire
