#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "tests/generator/program_generator.h"

namespace solitaire {

/// Holds the tracing engine's solutions of a program against brute force.
struct Comparison {
  enum class Outcome : std::uint8_t {
    kEqual,
    kDifferent,
    kSkipped,  // too many executions, or ints that symbolic evaluation does not take
  };
  Outcome outcome = Outcome::kEqual;
  std::string report;            // what differs, or why it was skipped
  bool refused = false;          // whether it was skipped since the tracing engine may refuse it
  std::uint64_t executions = 0;  // by brute force
  std::size_t solutions = 0;
  std::size_t errors = 0;   // different ones that executions came to
  bool incomplete = false;  // whether the random policy left paths unexplored
};

/// Runs the program in all executions, and with the tracing engine: with demand exploration as it is by
/// default and with as little as possible opened unasked, and with the sides that random executions open,
/// many and few. `seed` is the engines'.
Comparison compare_engines(const GeneratedProgram& program, std::uint64_t seed);

}  // namespace solitaire
