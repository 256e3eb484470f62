#pragma once
#include <cstdint>

#include "base/stop_signal.h"

namespace solitaire {

/// What bounds an evaluation.
struct Limits {
  std::uint64_t max_steps = 10'000'000;  // statements, calls and elements of one execution
  std::uint32_t max_depth = 4'000;       // calls within each other
  /// In a symbolic pass: how far a path that only some executions take may go before it is cut. A cut is a
  /// blocker like a closed side.
  std::uint64_t fuel_steps = UINT64_MAX;
  std::uint32_t fuel_depth = UINT32_MAX;
  /// Where paths join, a symbolic pass goes on with the steps of the shortest of them instead of the longest,
  /// which no execution may take.
  bool least_steps = false;
  /// The evaluation ends with Interrupted once it says so. May be null.
  const StopSignal* stop = nullptr;
  /// Executions go on past failed asserts, and past choices that lie outside of their range: for exploring
  /// paths, explanations and near misses. Then asserts are taken apart: each conjunct of a condition is
  /// looked at by itself, and one that cannot be evaluated does not hold.
  bool keep_going = false;
  /// In a symbolic pass that goes on: a comparison in an assert stays one where the ranges of choices say
  /// that it never holds, so that near misses can come near to it.
  bool open_comparisons = false;
};

}  // namespace solitaire
