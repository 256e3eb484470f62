#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "engines/solution.h"
#include "engines/solve/executions/explore.h"
#include "engines/solve/executions/method.h"
#include "engines/solve/executions/min_distance.h"
#include "engines/solve/pins/pins.h"
#include "solitaire/run/evaluator.h"

namespace solitaire {

/// Says how much is to be known of the things that a solution places into the scene.
enum class SceneDetail : std::uint8_t {
  kNone,        // nothing
  kPlacements,  // what they are, and where
  kProvenance,  // and the choices on which that depends
};

/// Says which solutions are run again after they were found. A run checks that the program accepts the
/// solution.
enum class Replay : std::uint8_t {
  kEvery,
  /// The first solution and those with the numbers 16, 256, 4096, ... are run. The others are read off the
  /// trace, in about a tenth of the time, where it says all that the program does.
  kSome,
};

/// The options of engines that look for solutions of a program by its trace graph.
struct TracingOptions {
  Exploration exploration;
  const SearchMethod* method = &cadical_method();
  std::uint64_t seed = 0;
  bool diverse = true;  // solutions that differ much, at some cost in speed; else as they come
  Replay replay = Replay::kEvery;
  SceneDetail scene = SceneDetail::kProvenance;  // of solutions
  bool far_apart = false;                        // with `diverse`: the most different solutions
  /// If true, of solutions that look alike one will do: not all need to be found, where they are gone through
  /// in order.
  bool one_of_alike = false;
  Apart apart = Apart::kChoices;  // what a further solution has to differ in, where the trace says it
  bool relax = false;             // asserts may be broken, as few as possible
  /// Seconds from the start of the search for a solution after which it is no longer made better.
  std::optional<double> improvement_time;
  std::vector<Pin> pins;
  DistanceBound min_distance;  // of choices, from solutions to keep away from
  std::uint64_t effort = 0;    // conflicts after which the solver gives a question up; 0: none
  Limits limits;               // of one execution; its stop signal ends the work

  /// Returns the same options with a method whose answers are proofs.
  TracingOptions exact() const {
    TracingOptions options = *this;
    options.method = &method->exact();
    return options;
  }
};

}  // namespace solitaire
