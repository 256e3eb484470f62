#pragma once
#include "engines/explain/condition_solver.h"
#include "engines/solve/tracing.h"
#include "engines/solve/wide_choices.h"

namespace solitaire {

/// A trace in which choices may lie outside of their ranges: where they may not, intervals decide conditions
/// that depend on them.
struct TracingEngine::WideTrace {
  explicit WideTrace(TracingEngine& engine)
      : choices(nullptr, kReach, engine.pins_),
        solver(engine.program_, engine.params_, exact(engine.options_), choices, engine.addresses_,
               engine.pins_) {}

  static TracingOptions exact(TracingOptions options) {
    options.backend = exact_backend(options.backend);
    return options;
  }

  static constexpr std::int64_t kReach = 4096;  // past most lengths that a layout compares with
  WideChoices choices;
  ConditionSolver solver;
};

}  // namespace solitaire
